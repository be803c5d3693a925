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

// What a frame of a sequence shows, for its file; "": it is none.
std::string frame_settings(const RenderArguments &arguments, const Frame &frame);
constexpr const char *settings_keyword = "Settings";  // of the text in the PNG

// Whether the frame's file is there already, whole, and need not be drawn again. Throws scenes::Failure with the first
// setting that differs, if the file there shows anything else.
bool is_finished(const RenderArguments &arguments, const Frame &frame);

}  // namespace cli
