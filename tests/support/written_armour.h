// A person in plates of armour, as large as a test wants it: the time of levels depends on triangles and materials.
#pragma once

#include <cstdint>

#include "tests/support/gltf_maker.h"

namespace claque::testing
{

// `plates` closed pieces round the limbs of the written person, each of a material of its own colour, with about
// `triangles` in all: skinned, with its clips. GLB; at most 60 000 triangles a plate.
Bytes written_armour(uint32_t plates, uint32_t triangles);

}  // namespace claque::testing
