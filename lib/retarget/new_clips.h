// Clips on their way into a rig: made aside first, so that a rig stays as it was where something fails.
#pragma once

#include "lib/retarget/joints.h"

namespace claque::retarget
{

// Places in `times` and `values` count from the beginning of these.
struct NewClips {
    std::vector<model::Clip> clips;
    std::vector<std::string> names;
    std::vector<model::Channel> channels;
    std::vector<float> times, values;
    std::vector<model::Marker> markers;  // of clips of these, in their order
    std::vector<std::string> marker_names;
};

// Copies channels of the clip; morph weights too, where the target has a morph set of that size on the bound node.
// Needs `agree`.
void copy_channels(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches,
                   uint32_t clip, NewClips &added);

// Whether copied channels show on the target what they show on the source: bound joints lie alike at rest, below what
// they hang on, and nothing between them moves.
bool rest_poses_agree(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches);

struct SkeletonAlignment;
void transfer(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches,
              const SkeletonAlignment &alignment, const Options &options, uint32_t clip, NewClips &added);

}  // namespace claque::retarget
