# `make install`: headers, libraries, prepared people, the claque command with its manual, the Python module, pkg-config
# and CMake packages; and what goes into which Debian package (cmake/package.cmake): components runtime, assets, people,
# stage, dev, command. The module is in none of them.
include(CMakePackageConfigHelpers)

install(DIRECTORY include/claque TYPE INCLUDE COMPONENT dev FILES_MATCHING PATTERN "*.h")
if(CLAQUE_STAGE)  # which the module needs; under /usr it lies where Debian's python3 looks
    install(DIRECTORY lib/python/claque DESTINATION lib/python3/dist-packages COMPONENT python
        FILES_MATCHING PATTERN "*.py" PATTERN __pycache__ EXCLUDE)
endif()

set(folder ${CMAKE_INSTALL_LIBDIR}/cmake/claque)
install(EXPORT claque DESTINATION ${folder} NAMESPACE claque:: FILE claque-targets.cmake COMPONENT dev)
configure_file(cmake/claque-config.cmake.in ${PROJECT_BINARY_DIR}/claque-config.cmake @ONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/claque-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/claque-config.cmake ${PROJECT_BINARY_DIR}/claque-config-version.cmake
    DESTINATION ${folder} COMPONENT dev)

# Written when it is installed, because only then is it known where to.
function(claque_pc library description requires private)
    configure_file(cmake/pc.cmake.in ${PROJECT_BINARY_DIR}/${library}-pc.cmake @ONLY)
    install(SCRIPT ${PROJECT_BINARY_DIR}/${library}-pc.cmake COMPONENT dev)
endfunction()
claque_pc(claque "Crowds for the fixed-function OpenGL 1.1 target" "" "-lstdc++ -lm")
if(CLAQUE_ASSETS)
    set(decoders ${CLAQUE_DECODER_LIBRARIES})
    list(TRANSFORM decoders PREPEND "-l")
    list(JOIN decoders " " decoders)
    claque_pc(claque-assets "Characters for claque: glTF files and built-in figures" claque "-lOpenMeshTools -lOpenMeshCore ${decoders} -lstdc++ -lm")
endif()
if(CLAQUE_STAGE)
    claque_pc(claque-stage "People who decide, for claque: state machines, a scheduler, flows" claque "-lstdc++ -lm")
endif()

# All that is installed.
set(installed claque claque_static)
foreach(target claque-assets claque-assets_static claque-stage claque-stage_static claque_people claque_manual claque_mpi
        osgdb_claque)
    if(TARGET ${target})
        list(APPEND installed ${target})
    endif()
endforeach()
add_custom_target(claque_installed DEPENDS ${installed})
