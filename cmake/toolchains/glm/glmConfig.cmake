# GLM for another machine: its headers are the same everywhere, but the folder they lie in has this machine's as well,
# so that a compiler for another one may see GLM alone.
set(glm_headers /usr/include/glm)
if(NOT EXISTS ${glm_headers}/glm.hpp)
    set(glm_FOUND FALSE)
    return()
endif()
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/headers)
file(CREATE_LINK ${glm_headers} ${CMAKE_BINARY_DIR}/headers/glm SYMBOLIC)
if(NOT TARGET glm::glm)
    add_library(glm::glm INTERFACE IMPORTED)
    target_include_directories(glm::glm INTERFACE ${CMAKE_BINARY_DIR}/headers)
endif()
