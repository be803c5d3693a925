// Ways over the ground that clips go (clip_notes.h): steps on the plane y = 0, and the turn about y.
#pragma once

#include "lib/model/rig.h"

namespace claque::model
{

// First the turn about y, then the shift.
struct GroundTransform {
    double x = 0, z = 0, yaw = 0;
};

GroundTransform compose(const GroundTransform &outer,
                        const GroundTransform &inner);  // inner in the space that outer leads to
GroundTransform inverse(const GroundTransform &step);
GroundTransform repeated(const GroundTransform &step, double times);  // `times` whole

// From one moment to another on the clip's own axis, round and round, in the space that it has reached at the first. Nothing
// of a clip that goes nowhere.
GroundTransform root_motion(const Rig &rig, uint32_t clip, double from_s, double to_s);

}  // namespace claque::model
