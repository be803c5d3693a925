// Decodes one image of a file.
#pragma once

#include "lib/asset/gltf_file.h"

namespace claque::asset
{

// `index` is one of the file's images. It is read from its buffer view, data URI or file; its content decides its
// format.
model::Image read_image(File &file, uint32_t index);

}  // namespace claque::asset
