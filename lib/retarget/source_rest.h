// Chooses the pose of the clips' skeleton that corresponds to the character's rest pose. Internal to lib/retarget.
//
// Files of clips rest in anything: a T-pose, the first pose of the clip, or every bone along one axis. Bones whose
// offsets agree have the same axes, so that local rotations mean the same, whatever the rest poses are.
#pragma once

#include "lib/retarget/alignment.h"

namespace claque::retarget
{

struct RestChoice {
    SourceRest kind = SourceRest::file;
    std::vector<glm::dquat> rotations;  // [matches] of the source's joints in that pose, in the source's model space
    SkeletonAlignment alignment;
    glm::dquat upright = glm::dquat(1, 0, 0, 0);  // from the source's model space to one whose y is up
    bool channels = false;                        // copied channels look the same on the target
};

// `clips`: those that are wanted. Throws base::Error (CLQ_ARGUMENT) for a frame that the first of them has not.
RestChoice choose_rest(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches,
                       const Options &options, const std::vector<uint32_t> &clips, std::vector<std::string> &warnings);

}  // namespace claque::retarget
