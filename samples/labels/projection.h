// Points of the world in the picture of a sample.
#pragma once

#include "samples/labels/sample.h"

namespace labels
{

// From the world to the eye, which looks along -z; and back.
std::array<double, 3> to_eye(const clq_camera &camera, const std::array<double, 3> &world);
std::array<double, 3> from_eye(const clq_camera &camera, const std::array<double, 3> &eye);

// A point in eye space in pixels from the top left corner; false: behind the eye.
bool project_eye(const Sample &sample, const std::array<double, 3> &eye, std::array<double, 2> &px);
// The same of a point in the world.
bool project(const Sample &sample, const std::array<double, 3> &world, std::array<double, 2> &px, double &depth_m);

}  // namespace labels
