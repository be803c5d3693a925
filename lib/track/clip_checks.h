// What clips and legs a locomotion needs. These functions throw base::Error (ARGUMENT) with names and numbers.
#pragma once

#include "lib/track/locomotion.h"

namespace claque::track
{

const char *clip_name(const model::Rig &rig, uint32_t clip);  // "" without one

// That the clips exist and that those that move have a length.
void check_clips(const model::Template &tmpl, const LocomotionClips &clips);

// The clip that has most weight at a step of the gait axis, and whether it is shown alone.
uint32_t clip_of_step(const LocomotionClips &clips, uint32_t step);
bool is_of_one_clip(const LocomotionClips &clips, uint32_t step);

// That low feet move back, so that the body goes to +z. `x`, `z`: how far they move in a cycle, in lengths of a leg.
// The message says where the character faces, and the turn that it needs.
void check_direction(const model::Template &tmpl, uint32_t clip, double x, double z);

// For a step of the gait axis at which no foot moves back.
[[noreturn]] void fail_to_walk(const model::Template &tmpl, const LocomotionClips &clips, uint32_t step);

// That the nodes exist and hang on each other.
void check_legs(const model::Template &tmpl, const LocomotionClips &clips);

// That torso, neck and head, where they are given, exist and hang on each other.
void check_upper(const model::Template &tmpl, const LocomotionClips &clips);

// After the measurement: that the walk walks, the run is faster and the slow walk slower.
void check_speeds(const model::Template &tmpl, const Locomotion &measured);

}  // namespace claque::track
