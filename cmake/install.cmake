# `make install`: headers, libraries, the claque command, pkg-config and CMake packages.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(DIRECTORY include/claque TYPE INCLUDE FILES_MATCHING PATTERN "*.h")
install(EXPORT claque DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/claque NAMESPACE claque:: FILE claque-targets.cmake)
file(WRITE ${CMAKE_BINARY_DIR}/claque-config.cmake "include(\"\${CMAKE_CURRENT_LIST_DIR}/claque-targets.cmake\")\n")
write_basic_package_version_file(${CMAKE_BINARY_DIR}/claque-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/claque-config.cmake ${CMAKE_BINARY_DIR}/claque-config-version.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/claque)

foreach(library claque claque-assets)
    if(library STREQUAL "claque")
        set(description "Crowds for the fixed-function OpenGL 1.1 target")
        set(requires "")
    else()
        set(description "Characters for claque: glTF files and built-in figures")
        set(requires "claque")
    endif()
    configure_file(cmake/claque.pc.in ${CMAKE_BINARY_DIR}/${library}.pc @ONLY)
    install(FILES ${CMAKE_BINARY_DIR}/${library}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()
