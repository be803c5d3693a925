// The only file that uses libdraco. What a stream says of its own size is compared with what the caller expects before
// the decoder believes it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lib/asset/accessor.h"

namespace claque::asset
{

struct DracoAttribute {
    std::string name;  // for messages
    uint32_t id = 0;   // of the stream
    Component component = Component::unknown;
    uint32_t width = 0;
    std::vector<uint8_t> bytes;  // filled: packed elements, one a vertex
};

struct DracoMesh {
    std::string path;                            // for messages
    uint64_t vertex_count = 0, index_count = 0;  // as the file says; the stream must agree
    uint64_t working_bytes = 0;                  // that the decoder may take
    std::vector<DracoAttribute> attributes;
    std::vector<uint32_t> indices;  // filled: three a triangle, below vertex_count
};

// Throws base::Error (CLQ_FORMAT, CLQ_UNSUPPORTED, CLQ_LIMIT) and std::bad_alloc.
void decode_draco(const Bytes &packed, DracoMesh &mesh);

}  // namespace claque::asset
