// What a window is asked to show: files of the command line, and files that are dropped on it.
#pragma once

#include "samples/cli/clip_arguments.h"
#include "samples/cli/track_arguments.h"

namespace cli
{

struct ViewWhat {
    SceneArguments setup;
    TrackArguments tracks;
    std::vector<std::string> textures;  // images that replace the character's own, the last one first
    ClipArguments clips;                // that the character has besides its own
    std::string colours;                // a colour map to wear and to design; empty: the scene's own colours
};

// Whether a file is a character; others are trajectories or a record.
bool is_view_character(const std::string &file);
bool is_colour_map(const std::string &path);
// Whether a file is shown by itself. Textures, clips, colour maps and camera paths change what is shown.
bool is_subject(const std::string &path);

// `what` with one more file, or with a scene or a built-in character of this name. Throws scenes::Failure where nothing
// is shown that the file could change.
ViewWhat with_file(ViewWhat what, const std::string &path);
// The same for a window that shows `what`: another subject takes the place of the one that is shown.
ViewWhat with_dropped(ViewWhat what, const std::string &path);

}  // namespace cli
