# CPack runs it between installing and packing: each package gets its licence, its changelog and its overrides of
# lintian, with their reasons; manual pages are packed.
set(changelog ${CPACK_TOPLEVEL_DIRECTORY}/changelog)
get_filename_component(source ${CPACK_RESOURCE_FILE_LICENSE} DIRECTORY)
execute_process(
    COMMAND ${CMAKE_CURRENT_LIST_DIR}/changelog.sh ${source}/CHANGELOG.md "${CPACK_PACKAGE_VERSION}" "${CPACK_PACKAGE_CONTACT}"
    OUTPUT_FILE ${changelog} COMMAND_ERROR_IS_FATAL ANY)
foreach(component ${CPACK_COMPONENTS_ALL})
    string(TOUPPER ${component} upper)
    set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
    set(share ${CPACK_TEMPORARY_DIRECTORY}/${component}${CPACK_PACKAGING_INSTALL_PREFIX}/share)
    configure_file(${CPACK_RESOURCE_FILE_LICENSE} ${share}/doc/${package}/copyright COPYONLY NO_SOURCE_PERMISSIONS)
    configure_file(${changelog} ${share}/doc/${package}/changelog COPYONLY NO_SOURCE_PERMISSIONS)
    if(EXISTS ${CMAKE_CURRENT_LIST_DIR}/${package}.lintian)
        configure_file(${CMAKE_CURRENT_LIST_DIR}/${package}.lintian ${share}/lintian/overrides/${package} COPYONLY NO_SOURCE_PERMISSIONS)
    endif()
    file(GLOB pages ${share}/man/man*/*)
    execute_process(COMMAND gzip -9n ${share}/doc/${package}/changelog ${pages} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
