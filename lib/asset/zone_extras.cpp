#include "lib/asset/zone_extras.h"

#include "lib/asset/zone_ranges.h"

namespace claque::asset
{

using base::fail;
using model::Zone;

namespace
{

void read_pair(const JsonView &view, float limit, bool may_wrap, float &first, float &last)
{
    float pair[2];
    view.numbers(pair, 2);
    if (!(pair[0] >= 0 && pair[1] >= 0 && pair[0] <= limit && pair[1] <= limit))
        fail(CLQ_FORMAT, "%s is %g to %g: both must be from 0 to %g", view.path().c_str(), static_cast<double>(pair[0]),
             static_cast<double>(pair[1]), static_cast<double>(limit));
    if (!may_wrap && pair[0] > pair[1]) fail(CLQ_FORMAT, "%s goes down", view.path().c_str());
    first = pair[0];
    last = pair[1];
}

Zone read_zone(const JsonView &view)
{
    Zone zone;
    zone.name = view["name"].text();
    if (zone.name.empty()) fail(CLQ_FORMAT, "%s is empty", view["name"].path().c_str());
    zone.key = static_cast<uint8_t>(view["key"].integer(0, 255));
    const JsonView colour = view["colour"];
    if (colour.exists()) colour.numbers(zone.colour.data(), 3);
    for (const float c : zone.colour)
        if (!(c >= 0 && c <= 1)) fail(CLQ_FORMAT, "%s has a number outside 0 to 1", colour.path().c_str());
    const JsonView hue = view["hue_deg"], saturation = view["saturation"], brightness = view["brightness"];
    if (!hue.exists() && !saturation.exists() && !brightness.exists()) {
        zone.range = default_range(zone.name, zone.colour, Texturing::textured);
        return zone;
    }
    read_pair(hue, 360, true, zone.range.hue_min_deg, zone.range.hue_max_deg);
    read_pair(saturation, 1, false, zone.range.saturation_min, zone.range.saturation_max);
    read_pair(brightness, 1, false, zone.range.brightness_min, zone.range.brightness_max);
    return zone;
}

}  // namespace

std::vector<Zone> read_zone_extras(const JsonView &extras)
{
    // Extras of other programs may be anything; only the member with claque's name is checked.
    if (!extras.exists() || !extras.is_object()) return {};
    const JsonView ours = extras["claque"];
    if (!ours.exists() || !ours["zones"].exists()) return {};
    const JsonView list = ours["zones"];
    std::vector<Zone> out;
    if (list.count() == 0) fail(CLQ_FORMAT, "%s is empty", list.path().c_str());
    if (list.count() > 256) fail(CLQ_FORMAT, "%s has %zu zones: 256 keys exist", list.path().c_str(), list.count());
    for (size_t i = 0; i < list.count(); ++i) add_keyed_zones(out, {read_zone(list.at(i))}, list.path());
    return out;
}

void add_keyed_zones(std::vector<Zone> &to, const std::vector<Zone> &zones, const std::string &path)
{
    for (const Zone &zone : zones) {
        bool known = false;
        for (const Zone &other : to)
            if (other.key == zone.key) {
                if (other.name != zone.name)
                    fail(CLQ_FORMAT, "%s: key %u means '%.60s' and '%.60s'", path.c_str(), zone.key, other.name.c_str(),
                         zone.name.c_str());
                known = true;
            }
        if (!known) to.push_back(zone);
    }
}

}  // namespace claque::asset
