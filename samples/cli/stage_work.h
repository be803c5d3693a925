// claque stage: what its options say.
#pragma once

#include "samples/cli/scene_arguments.h"
#include "samples/cli/sequence.h"

namespace cli
{

struct StageArguments {
    SceneArguments setup;
    std::string record, frames, out, json, save, restore;
    FrameRange range;
    double seconds = 0, fps = 25;  // 0: as the scenario says
    double at_s = -1;              // at which `save` is written; below 0: at the end
    bool apart = false, in_turn = false;
};

void run_stage(const StageArguments &arguments);

}  // namespace cli
