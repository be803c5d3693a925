// What an actor shows at a moment: the clip it plays, or the layers that its fades, gaits and gestures come to (S2 3.3). A
// function of time, seed and commands: any moment finds it by itself.
#pragma once

#include "lib/behave/behave.h"
#include "lib/pose/layer.h"

namespace claque::behave
{

struct ActiveClips {
    // Plain: one clip, where count is 0.
    uint32_t clip = model::none;
    double clip_time_s = 0;
    uint32_t count = 0;
    pose::Layer layers[pose::max_layers];
};

// `levels`: of its mechanisms, as in play_at().
void active_clips_at(const crowd::Crowd &crowd, uint32_t row, double time_s, MechanismLevels levels,
                     ActiveClips &out) noexcept;

// Whether shown_at() may come to layers at some moment.
inline bool may_blend(const crowd::Crowd &crowd, uint32_t row) noexcept
{
    return crowd.layers().of(row) || crowd.behaviours().blends(row);
}

// The share of a fade that has come, in [0, 1].
double fade_weight(crowd::Curve curve, double gone_s, double length_s) noexcept;

}  // namespace claque::behave
