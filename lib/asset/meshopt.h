// EXT_meshopt_compression: buffer views whose bytes libmeshoptimizer unpacks.
#pragma once

#include <cstdint>
#include <vector>

#include "lib/asset/json_view.h"

namespace claque::asset
{

enum class MeshoptMode { attributes, triangles, indices };
enum class MeshoptFilter { none, octahedral, quaternion, exponential };

// Where the packed bytes of a view are, and what they unpack to.
struct MeshoptView {
    std::string path;
    uint32_t buffer = 0;
    uint64_t offset = 0, length = 0;  // of the packed bytes
    uint64_t stride = 0, count = 0;   // of the elements that they unpack to
    MeshoptMode mode = MeshoptMode::attributes;
    MeshoptFilter filter = MeshoptFilter::none;
};

// Reads and checks the extension of a view whose byteLength is `view_bytes`. Throws base::Error (CLQ_FORMAT). The range
// of the packed bytes is for the caller to check.
MeshoptView read_meshopt_view(const JsonView &extension, size_t buffer_count, uint64_t view_bytes);

// Unpacks view.length bytes at `packed`. Throws base::Error (CLQ_FORMAT; CLQ_UNSUPPORTED if the build has no decoder).
std::vector<uint8_t> decode_meshopt(const MeshoptView &view, const uint8_t *packed);

}  // namespace claque::asset
