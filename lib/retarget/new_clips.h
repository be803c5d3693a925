// Clips before they are added to a rig. They are complete first, so that a failure leaves the rig unchanged. Internal
// to lib/retarget.
#pragma once

#include "lib/retarget/joints.h"

namespace claque::retarget
{

// Indices into `times` and `values` count from the start of these arrays.
struct NewClips {
    std::vector<model::Clip> clips;
    std::vector<std::string> names;
    std::vector<model::Channel> channels;
    std::vector<float> times, values;
    std::vector<model::Marker> markers;  // of these clips, in their order
    std::vector<std::string> marker_names;
};

// Copies the clip's channels; morph weights too, if the bound node of the target has a morph set of that size. Joints
// that do not rotate take the rotation of the source's rest. Requires rest_poses_agree(), or offsets that agree.
void copy_channels(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches,
                   uint32_t clip, NewClips &added);

// Returns whether copied channels look the same on the target: bound joints have the same rest transforms relative to
// their bound ancestors, and nothing between them moves.
bool rest_poses_agree(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches);

struct RestChoice;
class PoseCheck;
void transfer(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches,
              const RestChoice &rest, const Options &options, uint32_t clip, NewClips &added, PoseCheck &check);

}  // namespace claque::retarget
