// --colours and --reload, for commands that draw a stage frame by frame.
#pragma once

#include "samples/scenes/colours.h"
#include "samples/scenes/scene_renderer.h"

#include <CLI/CLI.hpp>

#include <optional>

namespace cli
{

struct ColourArguments {
    std::string file;  // empty: the scene's own colours
    bool reload = false;
};

void add_colour_options(CLI::App &command, ColourArguments &arguments);

// What the people on a stage wear.
class SceneColours
{
public:
    SceneColours(scenes::Library &library, const ColourArguments &arguments, uint64_t seed);

    // Before each frame. The first time it throws scenes::Failure where the file cannot be worn. With --reload a file that has
    // changed is taken up; one that is broken leaves the colours as they were, and standard error says why.
    void apply_to(const scenes::SceneRenderer &scene_renderer);

private:
    std::optional<scenes::ColourFile> file_;
    bool reload_, applied_ = false;
    uint64_t seed_;
};

}  // namespace cli
