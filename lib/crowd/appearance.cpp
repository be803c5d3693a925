// Colours of individuals: set by the host, or sampled inside HSB ranges, repeatably from seeds (S2 5).
#include "lib/base/error.h"
#include "lib/base/hash.h"
#include "lib/crowd/colour_sample.h"
#include "lib/crowd/edits.h"
#include "lib/crowd/rows.h"
#include "lib/math/hsb.h"

namespace claque::crowd
{

using base::fail;

namespace
{

void check_range(const model::HsbRange &range, uint32_t zone)
{
    const auto between = [](float x, float last) { return x >= 0 && x <= last; };
    if (!between(range.hue_min_deg, 360) || !between(range.hue_max_deg, 360) || !between(range.saturation_min, 1) ||
        !between(range.saturation_max, 1) || !between(range.brightness_min, 1) || !between(range.brightness_max, 1))
        fail(CLQ_ARGUMENT, "the range of zone %u leaves [0, 360] degrees or [0, 1]", zone);
}

void store(uint8_t *to, math::Rgb8 rgb) { to[0] = rgb.r, to[1] = rgb.g, to[2] = rgb.b; }

void require_zones(const model::Template &tmpl, uint32_t count)
{
    if (count != tmpl.zone_count())
        fail(CLQ_ARGUMENT, "%u zones were given; template '%s' has %u", count, tmpl.name.c_str(), tmpl.zone_count());
}

}  // namespace

void set_colours(Crowd &crowd, Id id, const float *rgb, uint32_t zone_count)
{
    const uint32_t row = crowd.row_of(id);
    require_zones(crowd.template_of(row), zone_count);
    for (uint32_t i = 0; i < 3 * zone_count; ++i)
        if (!(rgb[i] >= 0 && rgb[i] <= 1))
            fail(CLQ_ARGUMENT, "channel %u of zone %u is %g: it must lie in [0, 1]", i % 3, i / 3, double(rgb[i]));
    if (zone_count == 0) return;
    uint8_t *to = make_colours(crowd.tables, row);
    for (uint32_t zone = 0; zone < zone_count; ++zone) {
        const double colour[3] = {rgb[3 * zone], rgb[3 * zone + 1], rgb[3 * zone + 2]};
        store(to + 3 * zone, math::rgb8_of(colour));
    }
}

void randomise_colours(Crowd &crowd, Id id, const model::HsbRange *ranges, uint32_t count)
{
    const uint32_t row = crowd.row_of(id);
    const model::Template &tmpl = crowd.template_of(row);
    if (count == 0) {
        ranges = tmpl.zone_ranges.data();
    } else {
        require_zones(tmpl, count);
        for (uint32_t zone = 0; zone < count; ++zone) check_range(ranges[zone], zone);
    }
    if (tmpl.zone_count() == 0) return;
    uint8_t *to = make_colours(crowd.tables, row);
    for (uint32_t zone = 0; zone < tmpl.zone_count(); ++zone) {
        double rgb[3];
        rgb_of(ColourSample(crowd.seed(), crowd.actor(row).seed, zone).in(ranges[zone]), rgb);
        store(to + 3 * zone, math::rgb8_of(rgb));
    }
}

void set_texture_set(Crowd &crowd, Id id, uint32_t set)
{
    const uint32_t row = crowd.row_of(id);
    ActorRow &actor = crowd.tables.actors.all[row];
    const model::Template &tmpl = crowd.template_of(row);
    const uint32_t count = tmpl.texture_set_count();
    if (set == random_texture_set)
        set = static_cast<uint32_t>(base::hash(crowd.seed(), actor.seed, base::Purpose::texture_set) % count);
    if (set >= count)
        fail(CLQ_ARGUMENT, "texture set %u does not exist: template '%s' has %u", set, tmpl.name.c_str(), count);
    actor.texture_set = set;
    note(crowd, row);
}

}  // namespace claque::crowd
