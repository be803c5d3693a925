// Clips of the built-in characters: 30 keys per second, linear between them.
#pragma once

#include <vector>

#include "lib/figures/clips/pose.h"
#include "lib/model/rig.h"

namespace claque::figures
{

constexpr int keys_per_second = 30;

// The seat that seated clips expect: the height of its top, and its front edge behind the feet, which stand on the
// ground.
constexpr float seat_height_m = 0.43f;
constexpr float seat_edge_m = -0.17f;

enum class Ending : uint8_t {
    closed,  // a loop: the last key equals the first
    open     // a movement from one pose to another
};

// A clip as a function of its phase, 0 <= phase < 1 (<= 1 if open), and of nothing else, so that it closes.
struct ClipMaker {
    const char *name;
    int frames;  // length in thirtieths of a second
    Pose (*pose_at)(float phase);
    Ending ending = Ending::closed;
};

// The clips of every built-in character, in this order. Later ones are appended: clips keep their numbers.
const std::vector<ClipMaker> &figure_clips();

// walk_slow: it and those after it move as the others do, and levels of detail are not fitted to them.
constexpr uint32_t first_late_clip = 19;

Pose stand_at(float phase);
Pose walk_at(float phase);
Pose jog_at(float phase);
Pose walk_slow_at(float phase);
Pose turn_at(float phase);
Pose applaud_at(float phase);
Pose cheer_at(float phase);
float cheer_heels_deg(float phase);  // height of the heels off the ground
// Seated clips begin and end in sit_at(0).
Pose sit_at(float phase);
Pose sit_lean_at(float phase);
Pose sit_look_at(float phase);
Pose sit_talk_at(float phase);
Pose sit_applaud_at(float phase);
Pose sit_cheer_at(float phase);
Pose sit_laugh_at(float phase);
Pose sit_wave_at(float phase);
// From sit_at(0) to stand_at(0), and back.
Pose rise_at(float phase);
Pose sit_down_at(float phase);
// These begin and end in stand_at(0).
Pose stand_wave_at(float phase);
Pose stand_laugh_at(float phase);
Pose stand_applaud_at(float phase);
Pose stand_cheer_at(float phase);
Pose stand_look_at(float phase);
Pose stand_shift_at(float phase);

// Changes a pose so that it suits a figure of another build: a function of the pose alone, so that clips still join.
using Fit = void (*)(Pose &);

// Adds a clip: translations of the pelvis and of every node that moves, rotations of every node that turns. `fit` may
// be null.
void add_clip(model::Rig &rig, const ClipMaker &maker, Fit fit = nullptr);
// Adds a clip with one key per pose.
void add_clip(model::Rig &rig, const char *name, std::vector<Pose> poses, Fit fit = nullptr);

// A sine of the phase with `cycles` whole periods per clip, starting at the fraction `at` of a period; so it closes.
float wave(float phase, int cycles, float at = 0);

}  // namespace claque::figures
