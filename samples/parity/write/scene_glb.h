// The meshes, textures and materials of all who are shown, and each mesh once as its first individual shows it, as glTF.
#pragma once

#include "samples/parity/write/drawn_actors.h"
#include "samples/parity/write/glb.h"

namespace parity
{

// palettes: three rows of four a joint of each individual, as palettes.npy. projection: column-major.
std::string scene_glb(const DrawnActors &drawn_actors, const std::vector<float> &palettes, const float projection[16]);

}  // namespace parity
