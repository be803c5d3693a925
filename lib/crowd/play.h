// A clip with its clock.
#pragma once

#include <limits>

#include "lib/model/rig.h"

namespace claque::crowd
{

struct Play {
    uint32_t clip = model::none;  // of the template; none: the rest pose
    double start_s = 0;
    float speed = 1;
    float phase_s = 0;
};

constexpr double never_s = std::numeric_limits<double>::infinity();

}  // namespace claque::crowd
