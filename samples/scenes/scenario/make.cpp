// The scene of a scenario.
#include "samples/scenes/colours.h"
#include "samples/scenes/scenario/scenario.h"

namespace scenes
{
namespace
{

MakeScenario &maker_of_walkers()
{
    static MakeScenario make = nullptr;
    return make;
}

void colour_people(const Scene &scene, Library &library, const Scenario &scenario, uint64_t seed)
{
    asked_at(scenario.colours_at, [&] { ColourFile(library, scenario.colours).apply(scene, seed); });
}

}  // namespace

void draw_tracks_with(MakeScenario make) { maker_of_walkers() = make; }

std::unique_ptr<Scene> make_scenario(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario)
{
    const MakeScenario make = scenario.tracks ? maker_of_walkers() : make_theatre;
    if (!make) throw Failure(scenario.tracks->at + ": this program draws no people on tracks; the command claque does");
    std::unique_ptr<Scene> scene = make(library, crowd_options, scenario);
    if (!scenario.colours.empty()) colour_people(*scene, library, scenario, crowd_options.seed);
    return scene;
}

}  // namespace scenes
