# CPack runs it after packing: packages are packed again without CPack's scripts that call ldconfig, since Debian wants
# a trigger for it. CLAQUE_DEB_COMPRESSION names the compression; the tests make packages, and xz, which
# `make package` takes, would need twice as long as all else.
if(DEFINED ENV{CLAQUE_DEB_COMPRESSION})
    set(compression $ENV{CLAQUE_DEB_COMPRESSION})
else()
    set(compression gzip)
endif()
foreach(deb ${CPACK_PACKAGE_FILES})
    set(tree ${CPACK_TOPLEVEL_DIRECTORY}/repacked)
    file(REMOVE_RECURSE ${tree})
    execute_process(COMMAND dpkg-deb -R ${deb} ${tree} COMMAND_ERROR_IS_FATAL ANY)
    file(REMOVE ${tree}/DEBIAN/postinst ${tree}/DEBIAN/postrm)
    if(EXISTS ${tree}/DEBIAN/shlibs)
        file(WRITE ${tree}/DEBIAN/triggers "activate-noawait ldconfig\n")
    endif()
    execute_process(COMMAND dpkg-deb --root-owner-group -Z${compression} -b ${tree} ${deb} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
