// Clips of the built-in figures: 30 keys a second, straight between them, closed loops.
#pragma once

#include "lib/figures/clips/pose.h"
#include "lib/model/rig.h"

namespace claque::figures
{

constexpr int keys_per_second = 30;

// A clip as a function of its phase, 0 <= phase < 1, and of nothing else: so it closes.
struct ClipMaker {
    const char *name;
    int frames;  // length in thirtieths of a second
    Pose (*pose_at)(float phase);
};

Pose stand_at(float phase);
Pose walk_at(float phase);
Pose applaud_at(float phase);
Pose cheer_at(float phase);

// Adds a clip: rotations of every node that ever turns, and the pelvis' translation.
void add_clip(model::Rig &rig, const ClipMaker &maker);

// A wave of the phase, `cycles` whole turns a clip, starting at `at` of a turn: closes by itself.
float wave(float phase, int cycles, float at = 0);

}  // namespace claque::figures
