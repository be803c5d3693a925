#include "samples/scenes/social_classes.h"

#include "lib/base/near_names.h"
#include "samples/scenes/check.h"

namespace scenes
{

std::vector<clq_hsb_range> ranges_of(const clq_template *tmpl, const SocialClass &one)
{
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    std::vector<clq_hsb_range> ranges;
    std::vector<std::string> names;
    for (uint32_t zone = 0; zone < info.zone_count; ++zone) {
        clq_zone_info found = clq_zone_info_init();
        check(clq_template_get_zone(tmpl, zone, &found));
        ranges.push_back(found.range);
        names.emplace_back(found.name);
    }
    for (const SocialClass::Dye &dye : one.palette) {
        const uint32_t zone = clq_template_find_zone(tmpl, dye.zone.c_str());
        if (zone == CLQ_NONE)
            throw Failure((one.at.empty() ? "" : one.at + ": ") + "the " + one.name + " have a palette for '" +
                          dye.zone + "', and the character '" + one.character + "' has no such zone" +
                          claque::base::names_near(dye.zone, names));
        ranges[zone] = dye.range;
    }
    return ranges;
}

}  // namespace scenes
