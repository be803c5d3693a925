#include "samples/stage/setting.h"

#include "samples/scenes/shadows.h"

namespace staged
{

std::unique_ptr<Setting> make_setting(scenes::Library &library, const scenes::Scenario &scenario, uint64_t seed)
{
    if (scenario.theatre) return make_theatre_setting(library, scenario, seed);
    if (scenario.town) return make_town_setting(scenario);
    return make_area_setting(library, scenario, seed);
}

bool take_shadows_of(const Setting &setting, clq_shadow_def &def)
{
    const std::optional<double> height_m = setting.shadows_at_m();
    if (!height_m) return false;
    def = scenes::shadows_in(setting.light());
    def.plane_height = *height_m;
    setting.lay_shadows(def);
    return true;
}

}  // namespace staged
