// The people of a record (docs/records.md), on a ground of their own and seen by cameras that the record does not have.
#pragma once

#include "samples/scenes/walkers/record_file.h"
#include "samples/scenes/walkers/walkers.h"

namespace scenes::walkers
{

struct ReplayOptions {
    std::string file;
    std::vector<SocialClass> characters;  // for templates that no built-in character has the name of
    std::string follow;                   // the number of the actor that the camera follows; empty: it stands
};

// Times are those of the recorded run. Throws Failure.
std::unique_ptr<Scene> make_replay(Library &library, const CrowdOptions &crowd_options, const ReplayOptions &options);

}  // namespace scenes::walkers
