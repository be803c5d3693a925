// The meshes, textures and materials of all drawn individuals, and each mesh once in the pose of its first individual,
// as glTF.
#pragma once

#include "samples/parity/write/drawn_actors.h"
#include "samples/parity/write/glb.h"

namespace parity
{

// palettes: three rows of four for each joint of each individual, as in palettes.npy. projection: column-major.
std::string scene_glb(const DrawnActors &drawn_actors, const std::vector<float> &palettes, const float projection[16]);

}  // namespace parity
