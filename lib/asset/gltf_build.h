// Builds a Model from an opened file: nodes become the rig, primitives become parts.
#pragma once

#include "lib/asset/gltf_file.h"

namespace claque::asset
{

// Reads all of the file. Throws base::Error.
void build_model(File &file, model::Model &model);

}  // namespace claque::asset
