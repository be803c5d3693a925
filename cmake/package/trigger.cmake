# CPack runs it after packing: packages are packed again without CPack's scripts that call ldconfig, since Debian wants
# a trigger for it. The tests make packages, and xz would take twice as long as all else.
foreach(deb ${CPACK_PACKAGE_FILES})
    set(tree ${CPACK_TOPLEVEL_DIRECTORY}/repacked)
    file(REMOVE_RECURSE ${tree})
    execute_process(COMMAND dpkg-deb -R ${deb} ${tree} COMMAND_ERROR_IS_FATAL ANY)
    file(REMOVE ${tree}/DEBIAN/postinst ${tree}/DEBIAN/postrm)
    if(EXISTS ${tree}/DEBIAN/shlibs)
        file(WRITE ${tree}/DEBIAN/triggers "activate-noawait ldconfig\n")
    endif()
    execute_process(COMMAND dpkg-deb --root-owner-group -Zgzip -b ${tree} ${deb} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
