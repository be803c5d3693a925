// Compares the bones of two skeletons: offsets, directions at rest and in poses. Internal to lib/retarget.
#pragma once

#include "lib/retarget/joints.h"

namespace claque::retarget
{

// A bound joint and the nearest bound joint above it.
struct Bone {
    uint32_t upper = 0, lower = 0;  // matches
    double length = 0;              // of the target's, more than 0
};

std::vector<Bone> bones_of(const std::vector<JointMatch> &matches, const GlobalPose &target);

// Returns whether all bones have equal offsets in the frames of their upper joints, within 1 % of the limb's length
// once the source has the target's size. A limb reaches from one fork to the next or to its end. Bones that are all
// parallel agree never: nothing tells then how joints are turned about them. `scale` gets target size by source size.
bool offsets_agree(const std::vector<JointMatch> &matches, const GlobalPose &target, const GlobalPose &source,
                   double &scale);

// Returns the share of the bones' length, at most 1, that lies along one of the three axes: the most of them.
struct AxisShare {
    double share = 0;
    int axis = 0;
};
AxisShare along_one_axis(const std::vector<Bone> &bones, const std::vector<JointMatch> &matches,
                         const GlobalPose &source);

// Returns how much the bones of two poses point alike: the mean cosine, by the target's lengths.
double likeness(const std::vector<Bone> &bones, const std::vector<JointMatch> &matches, const GlobalPose &target,
                const GlobalPose &source, const glm::dquat &axes);

// Returns the rotation about y that turns the trunk of the source, whose axes are common already, to where that of the
// target faces. The trunk are joints that carry at least a third of all.
glm::dquat facing_rotation(const std::vector<Bone> &bones, const std::vector<JointMatch> &matches,
                           const GlobalPose &target, const GlobalPose &source, const glm::dquat &axes);

}  // namespace claque::retarget
