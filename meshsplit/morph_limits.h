// How far the weights of morph targets can go.
#pragma once

#include "lib/model/rig.h"

namespace claque::meshsplit
{

struct WeightLimits {
    float low = 0, high = 0;
};

// Of each weight of the pose, over the rest pose, all clips at any time and the degrees of freedom anywhere in their
// ranges. Cubic splines may swing beyond their keys: their limits hold that, and may be wider than what is reached.
std::vector<WeightLimits> morph_limits(const model::Rig &rig);

}  // namespace claque::meshsplit
