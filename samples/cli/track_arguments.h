// The options by which commands read trajectories (docs/trajectories.md) and show the people in them (docs/tracks.md).
#pragma once

#include "samples/cli/scene_arguments.h"
#include "samples/scenes/walkers/walkers.h"

namespace cli
{

struct TrackArguments {
    std::string file, columns, unit, up, picture, area, characters, camera, record;
    ClipArguments clips;               // of other files
    scenes::WalkingNodes limbs;        // of characters of files
    scenes::SocialClass::Clips gaits;  // likewise
    double rate_hz = 0, max_speed_m_s = 12;
    bool vehicles = false;
};

// --columns, --rate, --unit, --up, --max-speed, --vehicles: how a file is read.
void add_reading_options(CLI::App &command, TrackArguments &arguments);
// --legs, --torso, --neck, --head, --walk, --idle: nodes and clips of the characters of files that walk.
void add_limb_options(CLI::App &command, scenes::WalkingNodes &limbs, scenes::SocialClass::Clips &gaits);
// These, --characters and --ground: the characters that walk, and the ground below them.
void add_walking_options(CLI::App &command, TrackArguments &arguments);
// Throws CLI::ValidationError if one of them was given: the command's subject is no file of trajectories.
void refuse_track_options(const CLI::App &command);
void refuse_walking_options(const CLI::App &command);  // those of how people walk alone
// Throws likewise if one was given that says how positions are read, or where they are shown: the subject is a record.
void refuse_reading_options(const CLI::App &command, bool takes_rate = false);

// `columns` must live as long as the result.
std::vector<std::string> names_in(const std::string &list);  // separated by commas
clq_trajectories_def reading_of(const TrackArguments &arguments);
// `placed`: how characters of files are.
scenes::walkers::Options walkers_of(const TrackArguments &arguments, const scenes::Placement &placed);

// The times that a file of trajectories or a record has something for: the file's first sample is at 0, a record keeps
// the clock of its run. Throws scenes::Failure.
struct ShownTimes {
    double first_s = 0, last_s = 0;
};
ShownTimes times_of(const std::string &file, const clq_trajectories_def &reading);

// Whether a command's subject is a file of trajectories, not a scene or a character.
bool names_trajectories(const std::string &subject);
// A scenario of the people in the file alone.
std::shared_ptr<const scenes::Scenario> scenario_of(const TrackArguments &arguments, const scenes::Placement &placed);
// How the file is read, what walks and what the camera follows, for manifests.
Json tracks_about(const TrackArguments &arguments);

}  // namespace cli
