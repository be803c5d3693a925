# `make package`: .deb files of what `make install` installs; what they depend on is found by dpkg-shlibdeps (dpkg-dev).
set(soversion ${PROJECT_VERSION_MAJOR})
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME claque)
set(CPACK_PACKAGE_CONTACT "The claque developers <developers@claque.invalid>")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package/papers.cmake)
set(CPACK_POST_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package/trigger.cmake)
set(CPACK_COMPONENTS_ALL "")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE none)  # the post-build script compresses
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/lib/api ${PROJECT_BINARY_DIR}/lib/api/assets ${PROJECT_BINARY_DIR}/lib/stage)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)

# component, its package, its section, what it is in a line and in full, components that it needs
function(claque_deb component package section summary description)
    string(TOUPPER ${component} upper)
    set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package} PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}
claque draws crowds of animated individuals on fixed-function OpenGL 1.1,
skinned by the processor, in windows and scenes of other programs.

${description}" PARENT_SCOPE)
    set(CPACK_COMPONENT_${upper}_DEPENDS ${ARGN} PARENT_SCOPE)
endfunction()
claque_deb(runtime libclaque${soversion} libs "crowds for OpenGL 1.1: run time and splitting"
"This is the library that programs draw with. It loads prepared characters,
and needs no library but those of C and C++.")
set(libraries runtime)
if(CLAQUE_ASSETS)
    list(APPEND libraries assets)
    claque_deb(assets libclaque-assets${soversion} libs "crowds for OpenGL 1.1: characters from files, built-in figures"
"This is the library that reads glTF, BVH, images, trajectories and walkable
areas, makes levels of detail, and has people built in." runtime)
endif()
if(CLAQUE_STAGE)
    list(APPEND libraries stage)
    claque_deb(stage libclaque-stage${soversion} libs "crowds for OpenGL 1.1: people who decide"
"This is the library of agents: state machines, a scheduler, flows, and ways
that are found." runtime)
endif()
claque_deb(dev libclaque-dev libdevel "crowds for OpenGL 1.1: headers and static libraries"
"These are the headers of the C API, the static libraries, and packages for
pkg-config and CMake." ${libraries})
if(CLAQUE_SAMPLES)
    claque_deb(command claque graphics "crowds for OpenGL 1.1: the command"
"This is the claque command: it renders scenes and films, shows characters in
a window, inspects and prepares them, and writes labelled pictures." ${libraries})
endif()
if(TARGET claque_people)
    claque_deb(people claque-people graphics "crowds for OpenGL 1.1: prepared characters"
"These are the built-in characters with levels of detail, as the library would
make them at the first start.")
    set(CPACK_DEBIAN_PEOPLE_PACKAGE_ARCHITECTURE all)
    set(CPACK_DEBIAN_ASSETS_PACKAGE_RECOMMENDS "claque-people (= ${PROJECT_VERSION})")
endif()
if(TARGET claque_mpi)
    claque_deb(mpi claque-mpi graphics "crowds for OpenGL 1.1: the command under mpirun"
"With this module the ranks of an MPI job share the frames of a film." command)
endif()
if(TARGET osgdb_claque)
    claque_deb(osg osgdb-claque graphics "crowds for OpenGL 1.1: plugin of OpenSceneGraph"
"With this plugin programs of OpenSceneGraph, and so sumo-gui, read .claque
files as people." ${libraries})
endif()
# OpenGL is found at run time; either will do, and what needs none works without.
set(CPACK_DEBIAN_COMMAND_PACKAGE_RECOMMENDS "libosmesa6 | libegl1, libsdl2-2.0-0")
# For `claque view --serve` and its films.
set(CPACK_DEBIAN_COMMAND_PACKAGE_SUGGESTS "libvncserver1, ffmpeg")
list(JOIN CLAQUE_DECODER_PACKAGES ", " suggested)
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS libopenmesh-dev)  # these are for claque::assets_static
if(suggested)
    string(APPEND CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS ", ${suggested}")
endif()
include(CPack)
