// Pictures of a scene, one or a sequence: what `render` and `play` have in common.
#pragma once

#include <memory>

#include "samples/cli/clip_arguments.h"
#include "samples/cli/scene_arguments.h"
#include "samples/cli/sequence.h"

namespace cli
{

struct RenderArguments {
    SceneArguments setup;
    bool reload = false;  // of the file of colours
    ClipArguments clips;  // for the scene's FILE
    std::string clip;     // of FILE, which alone is shown; empty: all in turn
    double time_s = 2.0, fps = 25.0;
    std::string frames, out, json;
    FrameRange range;
    std::vector<int> list;  // of --frames; empty: the range
    int chunk = 0, chunk_count = 1;
    std::string manifest;
    bool portable = false;
    bool whole_path = false;  // frames up to the path's last key frame
    bool again = false;
    int processes = 0;                    // 0: one, or as many as a scheduler gave cores
    std::string divide;                   // frames or tiles; empty: frames of a sequence, tiles of a single picture
    uint32_t samples = 1;                 // pictures that are averaged into one
    Json scene;                           // what the files of a sequence depend on (film_about.h); null: there are none
    std::function<void()> drawn = [] {};  // called when all frames are drawn
};

// Options of the pictures, besides those that choose the scene.
void add_picture_options(CLI::App &command, const std::shared_ptr<RenderArguments> &arguments);
// Throws CLI::ValidationError.
void check_picture_usage(RenderArguments &arguments);
void render(const RenderArguments &arguments);

}  // namespace cli
