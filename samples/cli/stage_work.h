// claque stage: what its options say.
#pragma once

#include "samples/cli/scene_arguments.h"
#include "samples/cli/sequence.h"

namespace cli
{

struct StageArguments {
    SceneArguments setup;
    std::string record, frames, out, json;
    FrameRange range;
    double seconds = 0, fps = 25;  // 0: as the scenario says
    bool apart = false, in_turn = false;
};

void run_stage(const StageArguments &arguments);

}  // namespace cli
