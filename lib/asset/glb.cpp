#include "lib/asset/glb.h"

#include <cstring>

#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr uint32_t json_type = 0x4e4f534a, binary_type = 0x004e4942;

uint32_t word(const uint8_t *p)
{
    return uint32_t(p[0]) | uint32_t(p[1]) << 8 | uint32_t(p[2]) << 16 | uint32_t(p[3]) << 24;
}

void check_header(const uint8_t *bytes, size_t size)
{
    if (size < 12) fail(CLQ_FORMAT, "the GLB header is cut off after %zu bytes of 12", size);
    if (word(bytes + 4) != 2) fail(CLQ_UNSUPPORTED, "GLB version %u: only version 2 is read", word(bytes + 4));
    if (word(bytes + 8) > size || word(bytes + 8) < 12)
        fail(CLQ_FORMAT, "the GLB header says %u bytes, the file has %zu", word(bytes + 8), size);
}

}  // namespace

Container open_container(const uint8_t *bytes, size_t size)
{
    Container out;
    if (size < 4 || std::memcmp(bytes, "glTF", 4) != 0) {
        out.json = bytes;
        out.json_size = size;
        return out;
    }
    check_header(bytes, size);
    out.is_glb = true;
    out.left_out = size - word(bytes + 8);
    size -= out.left_out;
    size_t at = 12;
    for (size_t chunk = 0; at < size; ++chunk) {
        if (size - at < 8) fail(CLQ_FORMAT, "the header of GLB chunk %zu is cut off", chunk);
        const size_t length = word(bytes + at);
        const uint32_t type = word(bytes + at + 4);
        at += 8;
        if (length > size - at)
            fail(CLQ_FORMAT, "GLB chunk %zu says %zu bytes, %zu are left in the file", chunk, length, size - at);
        if (length % 4 != 0) fail(CLQ_FORMAT, "GLB chunk %zu has %zu bytes: not a multiple of 4", chunk, length);
        if ((chunk == 0) != (type == json_type))
            fail(CLQ_FORMAT, chunk == 0 ? "GLB chunk %zu is not the JSON" : "GLB chunk %zu is a second JSON", chunk);
        if (type == binary_type && chunk != 1) fail(CLQ_FORMAT, "GLB chunk %zu is binary: only chunk 1 may be", chunk);
        if (chunk == 0) out.json = bytes + at, out.json_size = length;
        if (type == binary_type) out.binary = bytes + at, out.binary_size = length, out.has_binary = true;
        at += length;
    }
    if (out.json_size == 0) fail(CLQ_FORMAT, "the GLB has no JSON in it");
    return out;
}

}  // namespace claque::asset
