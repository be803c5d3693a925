# The one place that decides which optional parts are built. A part whose packages are not found is left out, by a line
# that names them. CLAQUE_HAS_<PART> tells the folders.

# claque_part(PART PACKAGES WITHOUT FOUND...): builds PART if all variables FOUND are true, and else says WITHOUT, the
# loss. -DCLAQUE_WITH_<PART>=OFF leaves it out.
function(claque_part part packages without)
    option(CLAQUE_WITH_${part} "Build what needs ${packages}, where it is found" ON)
    set(has ${CLAQUE_WITH_${part}})
    foreach(found ${ARGN})
        if(NOT ${found})
            set(has OFF)
        endif()
    endforeach()
    if(NOT has)
        message(STATUS "claque: built without ${packages}: ${without}")
    endif()
    set(CLAQUE_HAS_${part} ${has} PARENT_SCOPE)
endfunction()

# Decoders and readers of libclaque-assets; lib/asset gets a definition CLAQUE_HAS_<NAME> for each.
set(CLAQUE_DECODERS "")            # names
set(CLAQUE_DECODER_LIBRARIES "")   # as a linker knows them
set(CLAQUE_DECODER_PACKAGES "")    # of Debian, for those that link libclaque-assets.a
foreach(decoder "DRACO|draco/compression/decode.h|draco|no glTF compressed with Draco"
                "MESHOPT|meshoptimizer.h|meshoptimizer|no glTF compressed with meshopt"
                "WEBP|webp/decode.h|webp|no textures in WebP"
                "EXPAT|expat.h|expat|no trajectories in XML"
                "SQLITE3|sqlite3.h|sqlite3|no trajectories in databases"
                "Z|zlib.h|z|no trajectories in gzip")
    string(REPLACE "|" ";" decoder ${decoder})
    list(GET decoder 0 name)
    list(GET decoder 1 header)
    list(GET decoder 2 library)
    list(GET decoder 3 without)
    find_path(CLAQUE_${name}_FOLDER ${header})
    find_library(CLAQUE_${name}_LIBRARY ${library})
    mark_as_advanced(CLAQUE_${name}_FOLDER CLAQUE_${name}_LIBRARY)
    claque_part(${name} lib${library} ${without} CLAQUE_${name}_FOLDER CLAQUE_${name}_LIBRARY)
    if(CLAQUE_HAS_${name})
        list(APPEND CLAQUE_DECODERS ${name})
        if(CLAQUE_PORTABLE)  # a name would find the shared one
            list(APPEND CLAQUE_DECODER_LIBRARIES ${CLAQUE_${name}_LIBRARY})
        else()
            list(APPEND CLAQUE_DECODER_LIBRARIES ${library})
        endif()
        list(APPEND CLAQUE_DECODER_PACKAGES lib${library}-dev)
    endif()
endforeach()

# Gives `target` the definitions.
function(claque_decoder_definitions target)
    foreach(name ${CLAQUE_DECODERS})
        target_compile_definitions(${target} PRIVATE CLAQUE_HAS_${name}=1)
    endforeach()
endfunction()

# People who find their way, by Recast and Detour.
if(CLAQUE_STAGE)
    find_path(CLAQUE_RECAST_FOLDER DetourCrowd.h PATH_SUFFIXES recastnavigation)
    set(libraries DetourCrowd Detour Recast)
    set(CLAQUE_RECAST_LIBRARIES "")
    foreach(library ${libraries})
        find_library(CLAQUE_${library} ${library})
        list(APPEND CLAQUE_RECAST_LIBRARIES ${CLAQUE_${library}})
    endforeach()
    list(TRANSFORM libraries PREPEND CLAQUE_)
    claque_part(NAVIGATION librecast-dev "people do not find their way, and there is no claque stage"
        CLAQUE_RECAST_FOLDER ${libraries})
endif()

if(CLAQUE_SAMPLES)
    find_path(CLAQUE_STB_WRITE_FOLDER stb/stb_image_write.h)
    claque_part(JPEG libstb-dev "labels are not tried as JPEG" CLAQUE_STB_WRITE_FOLDER)

    find_path(CLAQUE_ASSIMP_FOLDER assimp/Importer.hpp)
    find_library(CLAQUE_ASSIMP_LIBRARY assimp)
    claque_part(ASSIMP libassimp-dev "no claque convert" CLAQUE_ASSIMP_FOLDER CLAQUE_ASSIMP_LIBRARY)

    # Dear ImGui's backends are in Debian's static library. SDL2 is opened when a window is: its headers alone count.
    find_path(CLAQUE_IMGUI_FOLDER imgui.h PATH_SUFFIXES imgui)
    find_path(CLAQUE_IMGUI_BACKENDS imgui_impl_opengl2.h PATH_SUFFIXES imgui/backends)
    find_library(CLAQUE_IMGUI_LIBRARY libimgui.a)
    find_library(CLAQUE_STB_LIBRARY NAMES libstb.a stb)
    find_path(CLAQUE_SDL_FOLDER SDL2/SDL.h)
    claque_part(WINDOW "libimgui-dev and libsdl2-dev" "claque view has no window" CLAQUE_IMGUI_FOLDER
        CLAQUE_IMGUI_BACKENDS CLAQUE_IMGUI_LIBRARY CLAQUE_STB_LIBRARY CLAQUE_SDL_FOLDER)
    # LibVNCServer is opened when a window is served.
    find_path(CLAQUE_VNC_FOLDER rfb/rfb.h)
    claque_part(SERVE libvncserver-dev "claque view has no --serve" CLAQUE_VNC_FOLDER CLAQUE_HAS_WINDOW)

    find_package(MPI QUIET COMPONENTS C)
    claque_part(MPI libopenmpi-dev "no claque-mpi.so for mpirun" MPI_C_FOUND)

    # Hosts.
    find_package(GLUT QUIET)
    find_package(OpenGL QUIET)
    claque_part(GLUT libglut-dev "no samples/hosts/glut" GLUT_FOUND OPENGL_FOUND OPENGL_GLU_FOUND)
    find_package(OpenSceneGraph 3.6 QUIET COMPONENTS osgUtil osgViewer osgGA osgDB)
    claque_part(OSG libopenscenegraph-dev "no samples/hosts/osg, and no plugin for its programs"
        OPENSCENEGRAPH_FOUND OPENGL_FOUND)
    find_package(Coin 4 QUIET)
    claque_part(COIN libcoin-dev "no samples/hosts/coin" Coin_FOUND OPENGL_FOUND)
    find_package(embree 4 QUIET)
    if(NOT embree_FOUND)
        find_package(embree 3 QUIET)
    endif()
    claque_part(EMBREE libembree-dev "no samples/hosts/range" embree_FOUND)
endif()
