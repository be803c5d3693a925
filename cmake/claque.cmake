# Flags that are law (determinism) and the two functions that folders use.

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 99)
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_C_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

add_library(claque_flags INTERFACE)
target_compile_options(claque_flags INTERFACE
    -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wno-psabi
    $<$<BOOL:${CLAQUE_WERROR}>:-Werror>)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(i.86|x86)$" OR (CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64" AND CMAKE_SIZEOF_VOID_P EQUAL 4))
    target_compile_options(claque_flags INTERFACE -msse2 -mfpmath=sse)
endif()
target_compile_definitions(claque_flags INTERFACE $<$<BOOL:${CLAQUE_SCALAR}>:CLAQUE_SCALAR=1>)
target_include_directories(claque_flags INTERFACE ${PROJECT_SOURCE_DIR})

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

# A GoogleTest executable, every case its own CTest test. WORKING_DIRECTORY is the build folder of the test.
function(claque_test name)
    cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LIBRARIES;ENVIRONMENT" ${ARGN})
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 300)
    endif()
    add_executable(${name} ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE claque_flags ${ARG_LIBRARIES} GTest::gtest_main)
    target_compile_definitions(${name} PRIVATE
        CLAQUE_SOURCE_DIR="${PROJECT_SOURCE_DIR}" CLAQUE_ASSETS_DIR="${PROJECT_SOURCE_DIR}/../shared/assets")
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT ${ARG_TIMEOUT} ENVIRONMENT "${ARG_ENVIRONMENT}")
endfunction()
