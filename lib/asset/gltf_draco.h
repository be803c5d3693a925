// KHR_draco_mesh_compression: vertices and triangles of a primitive in one packed stream.
#pragma once

#include "lib/asset/gltf_file.h"

namespace claque::asset
{

// While it lives, the accessors of a primitive that Draco compressed are read from the unpacked stream. A primitive
// whose positions have bytes of their own is left as it is. Throws base::Error.
class DracoPrimitive
{
public:
    DracoPrimitive(File &file, const JsonView &primitive);
    ~DracoPrimitive() { file_.accessors.supply({}); }
    DracoPrimitive(const DracoPrimitive &) = delete;
    DracoPrimitive &operator=(const DracoPrimitive &) = delete;

    // True if the primitive is packed and has positions that are nowhere else.
    static bool is_packed(const File &file, const JsonView &primitive);

private:
    File &file_;
};

}  // namespace claque::asset
