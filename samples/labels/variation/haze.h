// Haze between the camera and what it sees, in the colour picture alone.
#pragma once

#include <claque/view.h>

#include <cstdint>
#include <vector>

namespace labels
{

// Mixes each pixel with the colour of the horizon, so that at `visibility_m` a twentieth of its own colour is left. The
// sky is seen through 300 m of haze above the camera.
//   rgb     [3 * width * height], top row first
//   depth   [width * height] of the same picture, as GL has it: [0, 1]; 1: the sky
void add_haze(std::vector<uint8_t> &rgb, const std::vector<float> &depth, int width, int height,
              const clq_camera &camera, double visibility_m);

}  // namespace labels
