// The frames that a command draws: their numbers, times and files.
#pragma once

#include <string>
#include <vector>

#include "samples/cli/render_work.h"

namespace cli
{

struct Frame {
    int number;  // -1: the single picture of --time
    double time_s;
    std::string path;
};

// All frames that the arguments name, of this job's share.
std::vector<Frame> planned_frames(const RenderArguments &arguments, const scenes::SceneOptions &options);

// Whether the frame's file is there already, whole, and need not be drawn again.
bool is_finished(const RenderArguments &arguments, const Frame &frame);

}  // namespace cli
