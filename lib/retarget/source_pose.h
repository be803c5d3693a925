// Samples the pose of a source clip at any time: rotations and positions of all joints in model space, in doubles.
// Internal to lib/retarget.
#pragma once

#include "lib/retarget/joints.h"

namespace claque::retarget
{

class SourcePose
{
public:
    SourcePose(const model::Rig &rig, uint32_t clip);
    void at(double time_s);  // on the clip's own time axis

    glm::dquat rotation(uint32_t node) const { return rotations_[node]; }
    glm::dvec3 position(uint32_t node) const { return dvec_of(globals_[node].column(3)); }

private:
    const model::Rig &rig_;
    model::Clip clip_;
    std::vector<math::Trs> locals_;
    std::vector<glm::dquat> rotations_;
    std::vector<math::Affine> globals_;
};

}  // namespace claque::retarget
