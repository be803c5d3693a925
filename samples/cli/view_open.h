// What a window shows: from the command line, or from a file that is dropped on it.
#pragma once

#include "samples/cli/track_arguments.h"
#include "samples/view/view.h"

namespace cli
{

struct ViewWhat {
    SceneArguments setup;
    TrackArguments tracks;
    std::vector<std::string> textures;  // images that the character's own are replaced by, the last one first
    std::string colours;                // of a file of colour classes; empty: the scene's own
};

// Whether the people of --characters stand side by side, as nothing else is shown.
bool lines_up(const ViewWhat &what);

// Whether a file is a character; others are trajectories or a record.
bool is_view_character(const std::string &file);

// Throws scenes::Failure.
view::Opened open_view(const ViewWhat &what, scenes::Library &library);

// What a dropped file shows (docs/view.md), after `what` and the files that were dropped before it.
std::function<view::Open(const std::string &path)> view_drops(const ViewWhat &what);

}  // namespace cli
