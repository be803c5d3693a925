# Decoders of libclaque-assets that a build may lack. Each that is found, and is not switched off, gets a definition
# CLAQUE_HAS_<NAME>.
set(CLAQUE_DECODERS "")            # names
set(CLAQUE_DECODER_LIBRARIES "")   # as a linker knows them
set(CLAQUE_DECODER_PACKAGES "")    # of Debian, for those that link libclaque-assets.a

function(claque_decoder name header library)
    option(CLAQUE_WITH_${name} "Read files that need lib${library}, where it is found" ON)
    find_path(CLAQUE_${name}_FOLDER ${header})
    find_library(CLAQUE_${name}_LIBRARY ${library})
    mark_as_advanced(CLAQUE_${name}_FOLDER CLAQUE_${name}_LIBRARY)
    if(NOT CLAQUE_WITH_${name} OR NOT CLAQUE_${name}_FOLDER OR NOT CLAQUE_${name}_LIBRARY)
        message(STATUS "claque: built without lib${library}")
        return()
    endif()
    set(CLAQUE_DECODERS ${CLAQUE_DECODERS} ${name} PARENT_SCOPE)
    set(CLAQUE_DECODER_LIBRARIES ${CLAQUE_DECODER_LIBRARIES} ${library} PARENT_SCOPE)
    set(CLAQUE_DECODER_PACKAGES ${CLAQUE_DECODER_PACKAGES} lib${library}-dev PARENT_SCOPE)
endfunction()

claque_decoder(DRACO draco/compression/decode.h draco)
claque_decoder(MESHOPT meshoptimizer.h meshoptimizer)
claque_decoder(WEBP webp/decode.h webp)
# Of the readers of trajectories.
claque_decoder(EXPAT expat.h expat)
claque_decoder(SQLITE3 sqlite3.h sqlite3)
claque_decoder(Z zlib.h z)

# Gives `target` the definitions.
function(claque_decoder_definitions target)
    foreach(name ${CLAQUE_DECODERS})
        target_compile_definitions(${target} PRIVATE CLAQUE_HAS_${name}=1)
    endforeach()
endfunction()
