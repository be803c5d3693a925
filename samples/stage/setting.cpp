#include "samples/stage/setting.h"

namespace staged
{

std::unique_ptr<Setting> make_setting(scenes::Library &library, const scenes::Scenario &scenario, uint64_t seed)
{
    if (scenario.theatre) return make_theatre_setting(library, scenario, seed);
    if (scenario.town) return make_town_setting(scenario);
    return make_area_setting(library, scenario, seed);
}

}  // namespace staged
