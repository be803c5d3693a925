// From what a file holds to a Model: which nodes become the rig, which primitives become parts.
#pragma once

#include "lib/asset/gltf_file.h"

namespace claque::asset
{

// Reads all of the file. Everything throws base::Error.
void build_model(File &file, model::Model &model);

}  // namespace claque::asset
