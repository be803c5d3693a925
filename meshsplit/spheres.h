// Computes the Sklsroot Bsphere, which is static and holds every pose of every clip. In S0 4.1 its radius was set by
// hand; here it follows from the clips, the degrees of freedom and the mesh.
#pragma once

#include <optional>

#include "meshsplit/allowance.h"

namespace claque::meshsplit
{

// Returns a sphere in model space that holds every vertex of every level at rest and in every pose of every clip, with
// every degree of freedom anywhere in its range (reach.h). Poses are sampled at all key times and at least 60 times a
// second between them; a bound of what vertices do between two poses is added.
// `vertices`: how many may be skinned one by one; beyond, they are bounded by the spheres of their joints. Nothing is
// returned if that needs more than `poses` poses.
std::optional<model::Sphere> enclosing_sphere(const model::Template &tmpl, const SearchLimits &limits = {});

// Returns the sample times of a clip, ascending. They include the last time of the old value before each key of a STEP
// channel.
std::vector<double> sample_times(const model::Rig &rig, uint32_t clip);
// How many they are, or a few more.
uint64_t sample_count(const model::Rig &rig, uint32_t clip);

}  // namespace claque::meshsplit
