// Decodes one image of a file.
#pragma once

#include <optional>

#include "lib/asset/gltf_file.h"

namespace claque::asset
{

// `index` is one of the file's images. It is read from its buffer view, data URI or file; its content decides its
// format. Nothing, with a warning, if its file cannot be read and the options are not strict.
std::optional<model::Image> read_image(File &file, uint32_t index);

}  // namespace claque::asset
