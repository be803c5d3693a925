// Looks at poses that were transferred, beside those of the clips' skeleton: the head above the hips, a foot lowest,
// arms outside the trunk. Joints that lie otherwise in the clip itself, as in a somersault, are right. Internal to
// lib/retarget.
#pragma once

#include <array>

#include "lib/retarget/joints.h"

namespace claque::retarget
{

class PoseCheck
{
public:
    PoseCheck(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches);

    // Positions of the matches: of the character, and of the clips' skeleton in the character's size, with y up.
    void look(uint32_t clip, double time_s, const std::vector<glm::dvec3> &own, const std::vector<glm::dvec3> &wanted);

    // One sentence for each kind of fault, with the key of the map that helps where the skeleton rested so.
    void tell(SourceRest rest, std::vector<std::string> &warnings) const;

private:
    struct Fault {
        std::string text;  // of the first clip that shows it
        uint32_t clip_count = 0, last_clip = model::none;
    };
    void note(Fault &fault, uint32_t clip, double time_s, const std::string &text);
    void find_limbs(const GlobalPose &rest);
    double to_trunk(const std::vector<glm::dvec3> &at, uint32_t match) const;
    const char *name(uint32_t match) const;

    const model::Rig &target_, &source_;
    const std::vector<JointMatch> &matches_;
    double height_ = 0;  // of the joints; 0: the character stands on no legs, and nothing is looked at
    uint32_t head_ = 0, hips_ = model::none;
    std::vector<uint32_t> feet_;
    std::vector<uint32_t> trunk_;          // from the hips upwards
    std::vector<uint32_t> roots_, limbs_;  // where arms begin; elbows, wrists and fingers
    Fault lying_, lifted_, inside_;
};

}  // namespace claque::retarget
