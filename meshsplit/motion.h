// Template::motion from the channels of its rig: which nodes are joints, at which rate each clip follows its channels
// within a given error, and what that error is.
#pragma once

#include "lib/model/template.h"

namespace claque::meshsplit
{

// How far a clip as sampled may be from its channels, at any key, between keys and between rows.
struct MotionTolerance {
    float metres = automatic;  // of any vertex or node; 0: clips stay with their channels
    float radians = 0.01f;     // that any node is turned
    // A two-thousandth of the character at rest, from its middle to what is farthest: half a millimetre of a body.
    static constexpr float automatic = -1;
};

// Needs rig and levels of `out`. Returns how much further away than by its channels anything can be.
float make_motion(const MotionTolerance &tolerance, model::Template &out);
// Makes the spheres of `out` so large that they hold its clips too.
void inflate(float more, model::Template &out);

}  // namespace claque::meshsplit
