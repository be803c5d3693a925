// --colours and --reload: what people wear, in scenes and in pictures of one character.
#pragma once

#include <optional>

#include <CLI/CLI.hpp>

#include "samples/scenes/colours.h"
#include "samples/scenes/placement.h"
#include "samples/scenes/scene_renderer.h"

namespace cli
{

// A FILE of colours, "wild" or "own" (docs/characters.md), for --colours.
CLI::Option *add_colours_option(CLI::App &command, std::string &file, scenes::Placement &placed,
                                const std::string &about);
// For commands with --colours that draw a scene frame by frame.
void add_reload_option(CLI::App &command, bool &reload);

// The people of the scene get the colours of the file when it is made; "": they keep the scene's own. Throws Failure
// where the file cannot be read.
void wear_colours(scenes::SceneOptions &options, const std::string &file);

// The colours of the people in a scene that wears a file's, where this file may change.
class SceneColours
{
public:
    SceneColours(scenes::Library &library, const std::string &file, bool reload, uint64_t seed);

    // Call this before each frame. A changed file is applied; a broken one leaves the colours as they were and is
    // reported on standard error.
    void apply_to(const scenes::SceneRenderer &scene_renderer);

private:
    std::optional<scenes::ColourFile> file_;  // none: it does not change
    uint64_t seed_;
};

// What one character wears of a map.
struct Worn {
    scenes::ColourMap map;  // none: the template's own ranges
    uint32_t colour_class = CLQ_NONE;

    void dress(clq_crowd *crowd, clq_actor actor) const;
};
// `named`: a class of the file; "": the one for the template. Throws Failure if the file has none.
Worn worn_by(scenes::Library &library, const clq_template *tmpl, const std::string &file, const std::string &named);

}  // namespace cli
