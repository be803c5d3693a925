// The way of a character over the ground in a clip: its shadow follows it, as the clip leads it away from its place.
#pragma once

#include <array>
#include <vector>

#include "samples/scenes/posed_template.h"

namespace scenes
{

class ClipWay
{
public:
    // `poses`: boxes at even times from the beginning of the clip to its end, in metres from the Reference Point.
    ClipWay(const std::vector<PoseBox> &poses, double length_s);

    // Whether the middle of the character moves over half a metre.
    bool is_long() const { return is_long_; }
    // The middle of the character on the ground: x and z.
    std::array<double, 2> at(double clip_time_s) const;

private:
    std::vector<std::array<double, 2>> middles_;
    double length_s_;
    bool is_long_ = false;
};

}  // namespace scenes
