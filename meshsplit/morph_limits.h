// Bounds of the weights of morph targets.
#pragma once

#include "lib/model/rig.h"

namespace claque::meshsplit
{

struct WeightLimits {
    float low = 0, high = 0;
};

// Returns the limits of each weight of the pose, over the rest pose, all clips at any time and the full ranges of the
// degrees of freedom. Cubic splines may exceed their keys; their limits include that and may be wider than what is
// reached.
std::vector<WeightLimits> morph_limits(const model::Rig &rig);

}  // namespace claque::meshsplit
