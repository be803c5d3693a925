// People who walk where a file of trajectories says that people were (docs/tracks.md): their tracks, a ground below
// them, and cameras that see them.
#pragma once

#include <claque/trajectories.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "samples/scenes/light.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/social_classes.h"

namespace scenes::walkers
{

struct Options {
    std::string file;  // of trajectories
    clq_trajectories_def reading = clq_trajectories_def_init();
    std::string columns;                          // of reading, kept
    std::optional<std::array<double, 2>> origin;  // of the scene in the file, metres; empty: the middle of the people
    std::vector<SocialClass> characters;          // in proportion to their shares; empty: the four built-in people
    std::string area;                             // a file of the walkable area; empty: a level ground
    double walls_m = 0.3;                         // height of the walls round the area
    std::string follow;                           // the id of the person that the camera follows; empty: it stands
    Daylight light;
    std::optional<Rgb> paving, around;  // of the ground; empty: stone, and grass
    struct Places {
        std::string file, area, follow;
    };
    Places places = {};  // where a scenario names them, for messages
    std::function<void(size_t done, size_t of)> progress = [](size_t, size_t) {};
};

// Throws Failure.
std::unique_ptr<Scene> make(Library &library, const CrowdOptions &crowd_options, const Options &options);

}  // namespace scenes::walkers
