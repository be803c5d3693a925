// Perlin's gradient noise: smooth, 0 at whole coordinates, the same on every machine.
#pragma once

#include <cstdint>

namespace scenes
{

// In [-1, 1]. Cells are 1 wide; with z 0 it is noise over the plane.
double gradient_noise(uint64_t seed, double x, double y, double z = 0);

}  // namespace scenes
