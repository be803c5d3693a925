// People who walk where a file of trajectories says that people were (docs/tracks.md): their tracks, a ground below
// them, and cameras that see them.
#pragma once

#include <claque/trajectories.h>

#include <functional>
#include <string>
#include <vector>

#include "samples/scenes/scene.h"

namespace scenes::walkers
{

struct Options {
    std::string file;  // of trajectories
    clq_trajectories_def reading = clq_trajectories_def_init();
    std::string columns;                  // of reading, kept
    std::vector<std::string> characters;  // built-in people, or glTF files; empty: the four built-in people
    std::string area;                     // a file of the walkable area; empty: a level ground
    std::string follow;                   // the id of the person whom the camera follows; empty: it stands
    std::function<void(size_t done, size_t of)> progress = [](size_t, size_t) {};
};

// Throws Failure.
std::unique_ptr<Scene> make(Library &library, const CrowdOptions &crowd_options, const Options &options);

}  // namespace scenes::walkers
