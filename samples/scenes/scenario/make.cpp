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

MakeScenario &maker_of_stages()
{
    static MakeScenario make = nullptr;
    return make;
}

MakeScenario &maker_of_people()
{
    static MakeScenario make = nullptr;
    return make;
}

MakeScenario maker_for(const Scenario &scenario)
{
    if (!scenario.people.empty()) {
        if (maker_of_people()) return maker_of_people();
        throw Failure(scenario.people[0].at_file +
                      ": this program draws no people with roles; the command claque does");
    }
    if (!scenario.stage && !scenario.tracks) return make_theatre;
    const MakeScenario make = scenario.stage ? maker_of_stages() : maker_of_walkers();
    if (!make)
        throw Failure((scenario.stage ? scenario.stage->at : scenario.tracks->at) + ": this program draws no people " +
                      (scenario.stage ? "that decide" : "on tracks") + "; the command claque does");
    return make;
}

void colour_people(const Scene &scene, Library &library, const Scenario &scenario, uint64_t seed)
{
    asked_at(scenario.colours_at, [&] { ColourFile(library, scenario.colours).apply(scene, seed); });
}

}  // namespace

void draw_tracks_with(MakeScenario make) { maker_of_walkers() = make; }
void draw_people_with(MakeScenario make) { maker_of_people() = make; }
void draw_stages_with(MakeScenario make) { maker_of_stages() = make; }

std::unique_ptr<Scene> make_scenario(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario)
{
    std::unique_ptr<Scene> scene = maker_for(scenario)(library, crowd_options, scenario);
    if (!scenario.colours.empty()) colour_people(*scene, library, scenario, crowd_options.seed);
    return scene;
}

}  // namespace scenes
