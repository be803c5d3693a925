// The GLB container (glTF 2.0, section 4): a header of twelve bytes, a JSON chunk and an optional binary chunk.
#pragma once

#include <cstddef>
#include <cstdint>

namespace claque::asset
{

// Points into the bytes of the file.
struct Container {
    const uint8_t *json = nullptr;
    size_t json_size = 0;
    const uint8_t *binary = nullptr;
    size_t binary_size = 0;
    size_t left_out = 0;  // bytes behind the end that the header says
    bool is_glb = false, has_binary = false;
};

// The first four bytes decide: GLB, or JSON in all of the file. Throws base::Error (CLQ_FORMAT; CLQ_UNSUPPORTED for
// another version of the container).
Container open_container(const uint8_t *bytes, size_t size);

}  // namespace claque::asset
