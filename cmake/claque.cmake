# Flags that are law (determinism) and the two functions that folders use.

include(GNUInstallDirs)
# Prepared people, as libclaque-assets.so finds them from its own folder.
file(RELATIVE_PATH CLAQUE_PEOPLE_FOLDER ${CMAKE_INSTALL_FULL_LIBDIR} ${CMAKE_INSTALL_FULL_DATADIR}/claque/people)

# Files of a folder are compiled in batches, which takes less time; the preset `dev` compiles each by itself.
if(NOT DEFINED CMAKE_UNITY_BUILD)
    set(CMAKE_UNITY_BUILD ON)
endif()
if(NOT DEFINED CMAKE_UNITY_BUILD_BATCH_SIZE)
    set(CMAKE_UNITY_BUILD_BATCH_SIZE 24)
endif()

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 99)
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_C_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
# What is built in another folder has the same bytes.
set(CMAKE_BUILD_RPATH_USE_ORIGIN ON)

# Libraries of the system are linked statically where they can be. None of their names is exported, as OpenGL drivers
# load newer expat and zlib into the same process. A map says which archives went into a file (cmake/wheel/licences.py).
# A build id would depend on the folder.
if(CLAQUE_PORTABLE)
    list(PREPEND CMAKE_FIND_LIBRARY_SUFFIXES .a)
    set(PKG_CONFIG_ARGN --static)
    set(pkgcfg_lib_CAIRO_m m CACHE INTERNAL "libm stays the system's")
    add_link_options(-Wl,--exclude-libs,ALL -Wl,--build-id=none -Wl,-Map,$<TARGET_PROPERTY:NAME>.map)
endif()

add_library(claque_flags INTERFACE)
target_compile_options(claque_flags INTERFACE
    -ffp-contract=off -Wall -Wextra -Wpedantic -Wno-psabi
    # From -O2 on GCC 12 leaves doubles that become floats and then doubles unrounded, where it packs two or more of
    # them into a vector (tests/unit/math/rounding_test.cpp).
    $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>
    # GCC takes what a view returns for a part of the view.
    $<$<AND:$<COMPILE_LANG_AND_ID:CXX,GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>>:-Wno-dangling-reference>
    # A unity build sees the file-level names of neighbours, and includes the files with fixtures of tests.
    $<$<NOT:$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wshadow>
    $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<COMPILE_LANG_AND_ID:CXX,GNU>>:-Wno-subobject-linkage>
    $<$<BOOL:${CLAQUE_WERROR}>:-Werror>)
# For code around the library, where the time to compile matters more than the time to run.
add_library(claque_quick_to_compile INTERFACE)
target_compile_options(claque_quick_to_compile INTERFACE $<$<CONFIG:Release>:-O1>)
# For tests and commands, most of which spend their time in libraries. Without optimisation GCC calls the C library's
# sqrt, and that of Windows does not round to the nearest, as the processor's does. A wheel has to be small.
set(claque_least -O0)
if(MINGW)
    set(claque_least -O1)
elseif(CLAQUE_PORTABLE)
    set(claque_least -Os)
endif()
add_library(claque_not_optimised INTERFACE)
target_compile_options(claque_not_optimised INTERFACE $<$<CONFIG:Release>:${claque_least}>)

if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(i.86|x86)$" OR (CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64" AND CMAKE_SIZEOF_VOID_P EQUAL 4))
    # Old hosts call with stacks aligned to 4 bytes.
    target_compile_options(claque_flags INTERFACE -msse2 -mfpmath=sse -mstackrealign)
endif()
if(WIN32)  # where programs find libraries beside themselves
    set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
endif()
if(MINGW)
    # GCC keeps 32-byte vectors on stacks that Windows aligns to 16 (GCC bug 54412): the assembler takes moves that do
    # not mind. Formats are checked on the other systems: here the compiler does not know %zu.
    target_compile_options(claque_flags INTERFACE -Wa,-muse-unaligned-vector-move -Wno-format)
    # printf with %zu, and the mathematical constants of <cmath>.
    target_compile_definitions(claque_flags INTERFACE __USE_MINGW_ANSI_STDIO=1 _USE_MATH_DEFINES)
endif()
target_compile_definitions(claque_flags INTERFACE $<$<BOOL:${CLAQUE_SCALAR}>:CLAQUE_SCALAR=1>)
target_include_directories(claque_flags INTERFACE ${PROJECT_SOURCE_DIR})

# Of kernels in vector types, for which clang takes minutes under UBSan.
set(CLAQUE_KERNEL_OPTIONS $<$<BOOL:${CLAQUE_FUZZERS}>:-fno-sanitize=undefined>)

# A room: static library claque_<name>, linked to the rooms below it.
function(claque_room name)
    cmake_parse_arguments(ARG "" "" "SOURCES;ROOMS;LIBRARIES" ${ARGN})
    add_library(claque_${name} STATIC ${ARG_SOURCES})
    target_include_directories(claque_${name} PUBLIC ${PROJECT_SOURCE_DIR}/include)
    target_compile_definitions(claque_${name} PUBLIC CLAQUE_BUILDING=1)
    target_link_libraries(claque_${name} PUBLIC claque_flags ${ARG_LIBRARIES})
    foreach(room ${ARG_ROOMS})
        target_link_libraries(claque_${name} PUBLIC claque_${room})
    endforeach()
endfunction()

# A room whose files are compiled in one batch: the templates and headers that they share are then compiled once.
function(claque_at_once name)
    math(EXPR batch "2 * ${CMAKE_UNITY_BUILD_BATCH_SIZE}")
    set_target_properties(claque_${name} PROPERTIES UNITY_BUILD_BATCH_SIZE ${batch})
endfunction()

# A room that works at start-up only: what -O3 adds to -O2 takes longer to compile than it ever saves.
function(claque_start_up name)
    target_compile_options(claque_${name} PRIVATE $<$<CONFIG:Release>:-O2>)
endfunction()

# A room that works briefly, or checks and calls others: nor does it save what -O2 takes.
function(claque_brief name)
    target_compile_options(claque_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# Sets OUT to a source file, made by the build, with claque::api::FUNCTION(): a hash of the sources that decide what a
# template is.
function(claque_sources_hash function out)
    file(GLOB_RECURSE makers CONFIGURE_DEPENDS
        ${PROJECT_SOURCE_DIR}/lib/*.h ${PROJECT_SOURCE_DIR}/lib/*.cpp ${PROJECT_SOURCE_DIR}/meshsplit/*.h
        ${PROJECT_SOURCE_DIR}/meshsplit/*.cpp)
    list(FILTER makers EXCLUDE REGEX "/lib/stage/")
    set(made ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
    add_custom_command(OUTPUT ${made}
        COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -DOUT=${made} -DFUNCTION=${function}
            -P ${PROJECT_SOURCE_DIR}/cmake/made_by.cmake
        DEPENDS ${makers} ${PROJECT_SOURCE_DIR}/cmake/made_by.cmake
        VERBATIM)
    # By itself, as it is made anew whenever a source changes.
    set_source_files_properties(${made} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    set(${out} ${made} PARENT_SCOPE)
endfunction()

# For sources of tests that compute much themselves.
function(claque_optimise)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS $<$<CONFIG:Release>:-O1>
        SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# All cases of a GoogleTest executable as one CTest test, which is skipped if every case is. The rest are properties.
function(claque_add_test test executable)
    add_test(NAME ${test} COMMAND ${executable})
    set_tests_properties(${test} PROPERTIES SKIP_REGULAR_EXPRESSION "\\[  PASSED  \\] 0 tests" ${ARGN})
endfunction()

# A GoogleTest executable, every case its own CTest test (for another machine: all of them one). WORKING_DIRECTORY is
# the build folder of the test. BYTES: it feeds readers or the C API with bytes and arguments of any kind; `make ci`
# runs it under sanitizers, too. LONG: without CLAQUE_LONG_TESTS, as by `make test`, it is left out; LONG_CASES: so are
# the cases that this filter matches. OPTIMISED: most of its time it runs code of its own. TOGETHER: its cases are one
# CTest test, as what they share takes longer to make than they take.
function(claque_test name)
    cmake_parse_arguments(ARG "BYTES;LONG;OPTIMISED;TOGETHER" "TIMEOUT;LONG_CASES" "SOURCES;LIBRARIES;ENVIRONMENT;PROPERTIES" ${ARGN})
    if(ARG_LONG AND NOT CLAQUE_LONG_TESTS)
        return()
    endif()
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 300)
    endif()
    if(CMAKE_CROSSCOMPILING_EMULATOR MATCHES qemu)  # which takes some 30 times as long for floating point
        math(EXPR ARG_TIMEOUT "4 * ${ARG_TIMEOUT}")
    endif()
    add_executable(${name} ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE claque_flags ${ARG_LIBRARIES} claque_patterns GTest::gtest_main)
    if(ARG_OPTIMISED)
        target_link_libraries(${name} PRIVATE claque_quick_to_compile)
    else()
        target_link_libraries(${name} PRIVATE claque_not_optimised)
        target_precompile_headers(${name} REUSE_FROM claque_test_headers)
    endif()
    target_compile_options(${name} PRIVATE -Wno-dangling-else)  # the macros of GoogleTest have one
    target_compile_definitions(${name} PRIVATE
        CLAQUE_SOURCE_DIR="${PROJECT_SOURCE_DIR}" CLAQUE_ASSETS_DIR="${PROJECT_SOURCE_DIR}/../shared/assets")
    set(properties TIMEOUT ${ARG_TIMEOUT} ${ARG_PROPERTIES}
        ENVIRONMENT_MODIFICATION XDG_CACHE_HOME=set:${PROJECT_BINARY_DIR}/cache)
    if(ARG_ENVIRONMENT)
        list(APPEND properties ENVIRONMENT ${ARG_ENVIRONMENT})
    endif()
    if(ARG_BYTES)
        list(APPEND properties LABELS bytes)
        add_dependencies(claque_bytes_tests ${name})
    endif()
    if(CMAKE_CROSSCOMPILING OR ARG_TOGETHER)  # every start of an emulator counts
        claque_add_test(${name} ${name} ${properties})
    else()
        set(cases "")
        if(ARG_LONG_CASES AND NOT CLAQUE_LONG_TESTS)
            set(cases TEST_FILTER -${ARG_LONG_CASES})
        endif()
        gtest_discover_tests(${name} ${cases} DISCOVERY_TIMEOUT 60 PROPERTIES ${properties})
    endif()
endfunction()

# A library from whole rooms: <name> shared with only clq_* exported, <name>_static beside it. Whether it is installed
# or a folder of theirs, other projects see claque::<as> and claque::<as>_static: claque::claque, claque::assets.
function(claque_libraries name)
    cmake_parse_arguments(ARG "" "" "ROOMS;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
    string(REPLACE "claque-" "" as ${name})
    string(REPLACE "claque" "runtime" component ${as})
    set(objects "")
    foreach(room ${ARG_ROOMS})
        list(APPEND objects $<TARGET_OBJECTS:claque_${room}>)
    endforeach()
    file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp "// Links ${name} as C++.\n")
    foreach(kind SHARED STATIC)
        set(target ${name})
        set(suffix "")
        if(kind STREQUAL STATIC)
            set(target ${name}_static)
            set(suffix _static)
        endif()
        add_library(${target} ${kind} ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp ${objects})
        set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name} EXPORT_NAME ${as}${suffix})
        add_library(claque::${as}${suffix} ALIAS ${target})
        target_include_directories(${target} PUBLIC
            $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
        foreach(library ${ARG_LIBRARIES})
            target_link_libraries(${target} PUBLIC ${library}${suffix})
        endforeach()
        target_link_libraries(${target} PRIVATE ${ARG_PRIVATE_LIBRARIES})
    endforeach()
    target_compile_definitions(${name}_static INTERFACE CLAQUE_STATIC=1)
    set_target_properties(${name} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}
        INSTALL_RPATH $ORIGIN LINK_DEPENDS ${PROJECT_SOURCE_DIR}/lib/api/exports.map)
    if(NOT WIN32)  # where CLQ_API says it all
        target_link_options(${name} PRIVATE -Wl,--version-script=${PROJECT_SOURCE_DIR}/lib/api/exports.map)
    endif()
    if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")  # whose run time the program brings
        target_link_options(${name} PRIVATE -Wl,--no-undefined)
    endif()
    if(CLAQUE_INSTALL)
        install(TARGETS ${name} ${name}_static EXPORT claque RUNTIME COMPONENT ${component}
            LIBRARY COMPONENT ${component} NAMELINK_COMPONENT dev ARCHIVE COMPONENT dev)
    else()  # a folder of another project, which makes what it links
        set_target_properties(${name} ${name}_static PROPERTIES EXCLUDE_FROM_ALL ON)
    endif()
endfunction()
