// Draws the frames of a film one by one. The scene is made when the first of them is drawn.
#pragma once

#include <optional>

#include "samples/cli/colour_arguments.h"
#include "samples/cli/film_frames.h"
#include "samples/processes/ranks.h"
#include "samples/processes/tile_borders.h"

namespace cli
{

// What a film's scene is, once it is made.
struct Subject {
    uint32_t count = 0;   // of individuals
    std::string context;  // what GL calls itself
};

class FrameDrawer
{
public:
    // `arguments` must live as long as this. `ranks`: those of the job, which share their templates; or null.
    FrameDrawer(const RenderArguments &arguments, int threads, processes::Ranks *ranks = nullptr);

    // Makes the scene, if it is not made yet. Throws scenes::Failure, as the next calls do.
    const Subject &subject();
    bool has_scene() const { return scene_renderer_.has_value(); }
    // Draws a frame and adds to its report what was drawn. Three bytes a pixel, valid until the next call.
    const std::vector<uint8_t> &draw(const Frame &frame, Json &report);
    // The same of a part of it.
    const std::vector<uint8_t> &draw(const Frame &frame, const processes::Tile &tile, Json &report);

    // Of the last frame, drawn whole, if a report is asked for.
    void add_hashes(const std::vector<uint8_t> &rgb, Json &report) const;

    scenes::SceneRenderer &scene_renderer() { return *scene_renderer_; }
    const scenes::SceneOptions &options() const { return options_; }
    const RenderArguments &arguments() const { return arguments_; }
    std::vector<std::string> warnings() const { return library_.warnings(); }

private:
    const RenderArguments &arguments_;
    scenes::Library library_;
    LoadedCharacter loaded_;
    scenes::SceneOptions options_;
    std::optional<scenes::SceneRenderer> scene_renderer_;
    std::optional<SceneColours> wardrobe_;
    Subject subject_;
};

// The bytes of a frame's file: a PNG that says what it shows, or its bare pixels for standard output.
std::vector<unsigned char> frame_bytes(const RenderArguments &arguments, const Frame &frame, const uint8_t *rgb,
                                       const scenes::SceneOptions &options, const Subject &subject);
// What a report says of any frame first.
Json frame_report(const Frame &frame);

}  // namespace cli
