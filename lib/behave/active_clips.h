// The clips that an actor shows at a time: one clip, or the weighted clips of its fades, gaits and layers (S2 3.3). A
// function of time, seed and commands, so that any time is found by itself.
#pragma once

#include "lib/behave/behave.h"
#include "lib/pose/layer.h"

namespace claque::behave
{

struct ActiveClips {
    // If count is 0: one clip at one time.
    uint32_t clip = model::none;
    double clip_time_s = 0;
    uint32_t count = 0;
    pose::Layer layers[pose::max_layers];
    // On a track: where its feet are, unless it shows other clips alone.
    pose::FootTarget feet[2];
    uint32_t foot_count = 0;
    pose::UpperTarget upper;  // and where it looks
};

// `levels`: of its mechanisms, as in plays_at().
void active_clips_at(const crowd::Crowd &crowd, uint32_t row, double time_s, MechanismLevels levels,
                     ActiveClips &out) noexcept;

// The weight in [0, 1] that a fade has reached.
double fade_weight(crowd::Curve curve, double gone_s, double length_s) noexcept;

}  // namespace claque::behave
