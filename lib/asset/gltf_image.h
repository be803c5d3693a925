// One image of a file, decoded.
#pragma once

#include "lib/asset/gltf_file.h"

namespace claque::asset
{

// `index` is one of the file's images. From its buffer view, data URI or file; what it is is decided by its content.
model::Image read_image(File &file, uint32_t index);

}  // namespace claque::asset
