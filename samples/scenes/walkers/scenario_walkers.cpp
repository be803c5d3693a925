#include "samples/scenes/walkers/scenario_walkers.h"

#include "samples/scenes/walkers/walkers.h"

namespace scenes::walkers
{

std::unique_ptr<Scene> make_scenario(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario)
{
    Options options;
    options.file = scenario.tracks->path;
    options.reading = scenario.tracks->reading;
    options.columns = scenario.tracks->columns;
    options.origin = scenario.tracks->origin;
    options.characters = scenario.characters;
    options.area = scenario.area;
    options.follow = scenario.follow;
    options.light = scenario.light.value_or(Daylight());
    options.paving = scenario.paving;
    options.around = scenario.around;
    options.places = {scenario.tracks->at, scenario.area_at, scenario.follow_at};
    return make(library, crowd_options, options);
}

}  // namespace scenes::walkers
