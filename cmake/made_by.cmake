# Writes OUT: claque::api::FUNCTION(), a hash of the sources below SOURCE_DIR that templates are made by.
file(GLOB_RECURSE sources RELATIVE ${SOURCE_DIR}
    ${SOURCE_DIR}/lib/*.h ${SOURCE_DIR}/lib/*.cpp ${SOURCE_DIR}/meshsplit/*.h ${SOURCE_DIR}/meshsplit/*.cpp)
list(FILTER sources EXCLUDE REGEX "^lib/stage/")  # which makes none
list(SORT sources)
set(all "")
foreach(source ${sources})
    file(SHA256 ${SOURCE_DIR}/${source} hash)
    string(APPEND all "${source} ${hash}\n")
endforeach()
string(SHA256 hash "${all}")
file(WRITE ${OUT} "#include \"lib/api/build_id.h\"\n\nconst char *claque::api::${FUNCTION}() { return \"${hash}\"; }\n")
