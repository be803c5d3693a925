// Things to carry, and the belt of a treadmill, as scenery.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "samples/scenes/eye.h"
#include "samples/scenes/geometry.h"

namespace scenes::roles
{

const std::vector<std::string> &object_names();
bool is_object(const std::string &name);
// Of its bounding sphere round the joint, metres.
float radius_of_object(const std::string &name);

// At a node's matrix in the world, metres whatever the node's scale.
void draw_object(const Gl &gl, const Eye &eye, const std::string &name, const double (&node)[16]);

// Below a person at `at` that looks along the heading; `moved_m` of the ground.
void draw_belt(const Gl &gl, const Eye &eye, const std::array<double, 3> &at, double heading_rad, double moved_m);

// What a gaze is drawn to.
void draw_target(const Gl &gl, const Eye &eye, const std::array<double, 3> &at);
// A closed way through corners: x, y, z of each.
void draw_way(const Gl &gl, const Eye &eye, const std::vector<double> &corners);

}  // namespace scenes::roles
