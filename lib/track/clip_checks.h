// What clips and legs a locomotion needs. These functions throw base::Error (ARGUMENT) with names and numbers.
#pragma once

#include "lib/track/locomotion.h"

namespace claque::track
{

const char *clip_name(const model::Rig &rig, uint32_t clip);  // "" without one

// That the clips exist and that those that move have a length.
void check_clips(const model::Template &tmpl, const LocomotionClips &clips);

// That the nodes exist and hang on each other.
void check_legs(const model::Template &tmpl, const LocomotionClips &clips);

// That torso, neck and head, where they are given, exist and hang on each other.
void check_upper(const model::Template &tmpl, const LocomotionClips &clips);

// After the measurement: that the walk walks, the run is faster and the slow walk slower.
void check_speeds(const model::Template &tmpl, const Locomotion &measured);

}  // namespace claque::track
