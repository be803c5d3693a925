// --colours and --reload, for commands that draw a scene frame by frame.
#pragma once

#include <optional>

#include <CLI/CLI.hpp>

#include "samples/scenes/colours.h"
#include "samples/scenes/scene_renderer.h"

namespace cli
{

struct ColourArguments {
    std::string file;   // empty: the scene's own colours
    bool wild = false;  // of characters from files
    bool reload = false;
};

// A FILE of colours, or "wild" (docs/characters.md), for --colours.
CLI::Option *add_colours_option(CLI::App &command, std::string &file, bool &wild, const std::string &about);
// The same and --reload.
void add_colour_options(CLI::App &command, ColourArguments &arguments);

// The colours of the people in a scene.
class SceneColours
{
public:
    SceneColours(scenes::Library &library, const ColourArguments &arguments, uint64_t seed);

    // Call this before each frame. The first call throws scenes::Failure if the file cannot be applied. With --reload
    // a changed file is applied; a broken one leaves the colours as they were and is reported on standard error.
    void apply_to(const scenes::SceneRenderer &scene_renderer);

private:
    std::optional<scenes::ColourFile> file_;
    bool reload_, applied_ = false;
    uint64_t seed_;
};

}  // namespace cli
