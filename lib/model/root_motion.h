// Root motion of clips (clip_annotations.h): translations on the plane y = 0 and rotations about y.
#pragma once

#include "lib/model/rig.h"

namespace claque::model
{

// First the rotation about y, then the translation.
struct GroundTransform {
    double x = 0, z = 0, yaw = 0;
};

// `inner` is given in the space that `outer` leads to.
GroundTransform compose(const GroundTransform &outer, const GroundTransform &inner);
GroundTransform inverse(const GroundTransform &step);
GroundTransform repeated(const GroundTransform &step, double times);  // `times` is a whole number

// The root motion between two times of the looping clip, on its own axis, in the space that it has reached at from_s.
// The identity for a clip without root motion.
GroundTransform root_motion(const Rig &rig, uint32_t clip, double from_s, double to_s);

}  // namespace claque::model
