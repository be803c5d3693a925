// Scenario files (docs/scenarios.md): the people of a scene and their colours, where they sit or walk, how a camera
// moves, the light and the ground.
#pragma once

#include <claque/trajectories.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "samples/scenes/camera_path.h"
#include "samples/scenes/light.h"
#include "samples/scenes/odeon/theatre.h"
#include "samples/scenes/roles/person.h"
#include "samples/scenes/scenario/staging.h"
#include "samples/scenes/scene.h"

namespace scenes
{

// A file of trajectories, and how it is read.
struct TrackFile {
    std::string path, columns;
    clq_trajectories_def reading = clq_trajectories_def_init();  // without its columns
    std::optional<std::array<double, 2>> origin;                 // of the scene in the file, metres
    std::string at;                                              // in the scenario, for messages
};

struct Scenario {
    std::string name;
    std::vector<SocialClass> characters;
    // One of these; a stage may be in a theatre.
    std::optional<Theatre> theatre;
    std::optional<TrackFile> tracks;
    std::optional<Staging> stage;
    std::optional<ScenarioTown> town;
    std::vector<roles::Person> people;

    std::optional<CameraPath> path;
    std::string follow;  // the id of the person that the camera follows; empty: it stands
    std::optional<Daylight> light;
    std::optional<Rgb> paving, around;
    std::string area;                            // a file of the walkable area; empty: a level ground
    std::string colours;                         // a colour map, as a file; empty: each class has its palette
    std::string follow_at, area_at, colours_at;  // in the scenario, for messages
    std::vector<std::string> files;              // all that it names, in their order
};

// What a scenario names besides itself.
struct ScenarioFiles {
    std::string folder;  // that names are relative to: empty, or with a slash at its end
    // Both return a sentence that says why not, or "".
    std::function<std::string(const std::string &path, std::string &text)> read;
    std::function<std::string(const std::string &path)> find;
    std::string mechanisms = "";  // the folder of shared objects that may be loaded; empty: none
};

// Files whose names are relative to the folder of the file `path`.
ScenarioFiles files_beside(const std::string &path);

// `where` names it in error messages. Throws Failure with line, column and rule if the text is not TOML, lacks
// something, contradicts itself, or names a file that is not there.
Scenario read_scenario(const std::string &toml, const std::string &where, const ScenarioFiles &files);
// Of a file; names in it are relative to its folder. `mechanisms`: as in ScenarioFiles.
Scenario load_scenario(const std::string &path, const std::string &mechanisms = "");

// The scenario that comes with claque (odeon/odeon.toml), and its text.
const Scenario &odeon_scenario();
const std::string &odeon_description();

// The scene of a scenario, with its colours. `scenario` must live as long as the scene. Throws Failure.
std::unique_ptr<Scene> make_scenario(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario);
std::unique_ptr<Scene> make_theatre(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario);

// What makes the scenes of scenarios with tracks (walkers/scenario_walkers.h). A program that draws them says so first;
// others, which are built without people on tracks, refuse them.
using MakeScenario = std::unique_ptr<Scene> (*)(Library &, const CrowdOptions &, const Scenario &);
void draw_tracks_with(MakeScenario make);
// The same for agents that decide (samples/stage/staged_scene.h).
void draw_stages_with(MakeScenario make);
// And for people with roles (samples/scenes/roles/roles_scene.h).
void draw_people_with(MakeScenario make);

}  // namespace scenes
