#include "samples/scenes/clip_way.h"

#include <algorithm>

namespace scenes
{

ClipWay::ClipWay(const std::vector<PoseBox> &poses, double length_s) : length_s_(length_s)
{
    PoseBox all = PoseBox::none();
    for (const PoseBox &box : poses) {
        if (box.is_none()) continue;
        const std::array<double, 3> middle = {(box.low[0] + box.high[0]) / 2, 0, (box.low[2] + box.high[2]) / 2};
        middles_.push_back({middle[0], middle[2]});
        all.hold(middle);
    }
    if (middles_.empty()) middles_.push_back({0, 0});
    is_long_ = all.size(0) > 0.5 || all.size(2) > 0.5;
}

std::array<double, 2> ClipWay::at(double clip_time_s) const
{
    const double last = static_cast<double>(middles_.size() - 1);
    const double place = length_s_ > 0 ? std::clamp(clip_time_s / length_s_, 0.0, 1.0) * last : 0;
    const size_t before = static_cast<size_t>(place), after = std::min(before + 1, middles_.size() - 1);
    const double share = place - static_cast<double>(before);
    std::array<double, 2> out;
    for (size_t k = 0; k < 2; ++k) out[k] = middles_[before][k] * (1 - share) + middles_[after][k] * share;
    return out;
}

}  // namespace scenes
