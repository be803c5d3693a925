// The GLB container: twelve bytes of header, a JSON chunk, perhaps a binary chunk. glTF 2.0, section 4.
#pragma once

#include <cstddef>
#include <cstdint>

namespace claque::asset
{

// Points into the file's bytes.
struct Container {
    const uint8_t *json = nullptr;
    size_t json_size = 0;
    const uint8_t *binary = nullptr;
    size_t binary_size = 0;
    bool is_glb = false, has_binary = false;
};

// Decides by the first four bytes: GLB, or all of it is JSON. Throws base::Error (CLQ_FORMAT; CLQ_UNSUPPORTED for
// another version of the container).
Container open_container(const uint8_t *bytes, size_t size);

}  // namespace claque::asset
