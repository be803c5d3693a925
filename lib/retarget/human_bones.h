// Binds skeletons of people whose names differ: by the bones that VRM files list, else by the usual names of Mixamo,
// CMU, LAFAN1, Bandai-Namco, Unreal, VRM, KayKit, Daz, Poser, Maya and claque's own people. Internal to lib/retarget.
#pragma once

#include "lib/retarget/joints.h"

namespace claque::retarget
{

struct HumanBinding {
    std::vector<JointMatch> matches;   // arms and legs are aligned; empty unless hips, legs and ten joints are bound
    std::vector<Follower> followers;   // skirts, which follow the thighs
    std::vector<std::string> unbound;  // limbs and head that one of the skeletons lacks, by VRM's names
};

HumanBinding bind_human(const model::Rig &target, const model::Rig &source, const Options &options);

}  // namespace claque::retarget
