#include "lib/figures/charts.h"

#include "lib/base/error.h"

namespace claque::figures
{

namespace
{

const char *name_of(Zone zone)
{
    switch (zone) {
        case Zone::skin:
            return "skin";
        case Zone::hair:
            return "hair";
        case Zone::eyes:
            return "eyes";
        case Zone::lips:
            return "lips";
        case Zone::tunic:
            return "tunic";
        case Zone::belt:
            return "belt";
        case Zone::border:
            return "border";
        case Zone::sandals:
            return "sandals";
        case Zone::outer:
            return "outer";
        case Zone::jewellery:
            return "jewellery";
        case Zone::wings:
            break;
    }
    return "wings";
}

uint8_t key_at(size_t place, size_t count) { return static_cast<uint8_t>(16 + (count <= 8 ? 32 : 24) * place); }

}  // namespace

std::vector<model::Zone> zones_of(const Zones &zones)
{
    std::vector<model::Zone> made;
    for (size_t i = 0; i < zones.size(); ++i) {
        model::Zone zone;
        zone.name = name_of(zones[i].zone);
        zone.key = key_at(i, zones.size());
        zone.colour = zones[i].colour;
        zone.range = zones[i].range;
        made.push_back(zone);
    }
    return made;
}

uint8_t key_of(const Zones &zones, Zone zone)
{
    for (size_t i = 0; i < zones.size(); ++i)
        if (zones[i].zone == zone) return key_at(i, zones.size());
    base::fail(CLQ_ARGUMENT, "a painter names the zone '%s', which its figure does not have", name_of(zone));
}

}  // namespace claque::figures
