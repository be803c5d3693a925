#include "lib/crowd/colour_map.h"

#include <cstring>

#include "lib/base/error.h"
#include "lib/base/near_names.h"
#include "lib/crowd/colour_sample.h"
#include "lib/model/colour_rules.h"

namespace claque::crowd
{

using base::fail;

namespace
{

model::HsbRange range_of(const clq_hsb_range &r)
{
    return {r.hue_min_deg, r.hue_max_deg, r.saturation_min, r.saturation_max, r.brightness_min, r.brightness_max};
}

size_t bytes_of(const char *text) { return text ? std::strlen(text) + 1 : 0; }

}  // namespace

ColourMap::ColourMap(std::pmr::memory_resource *memory, const clq_colour_map_def &def)
    : def_(def), texts_(memory), classes_(memory), zones_(memory), palette_(memory), table_of_(memory), tables_(memory)
{
    const model::BrokenColourRule rule = model::first_broken_rule(def);
    if (rule.broken) fail(CLQ_ARGUMENT, "%s", rule.text.c_str());
    size_t text_bytes = 0, zones = 0, palette = 0;
    for (uint32_t c = 0; c < def.class_count; ++c) {
        const clq_colour_class &colours = def.classes[c];
        text_bytes += bytes_of(colours.name) + bytes_of(colours.tmpl);
        zones += colours.zone_count;
        for (uint32_t z = 0; z < colours.zone_count; ++z) {
            text_bytes += bytes_of(colours.zones[z].zone) + bytes_of(colours.zones[z].linked_to);
            palette += colours.zones[z].palette_count;
        }
    }
    // Pointers into these arrays must stay valid.
    texts_.reserve(text_bytes);
    classes_.reserve(def.class_count);
    zones_.reserve(zones);
    palette_.reserve(palette);
    for (uint32_t c = 0; c < def.class_count; ++c) {
        clq_colour_class colours = def.classes[c];
        const clq_zone_colours *given = colours.zones;
        colours.name = keep(colours.name);
        colours.tmpl = keep(colours.tmpl);
        colours.zones = zones_.data() + zones_.size();
        for (uint32_t z = 0; z < colours.zone_count; ++z) {
            clq_zone_colours zone = given[z];
            zone.zone = keep(zone.zone);
            zone.linked_to = keep(zone.linked_to);
            zone.palette = palette_.data() + palette_.size();
            for (uint32_t d = 0; d < zone.palette_count; ++d) {
                palette_.push_back(given[z].palette[d]);
                const bool even = zone.colour_space == CLQ_COLOUR_SPACE_OKLAB;
                table_of_.push_back(even ? static_cast<uint32_t>(tables_.size()) : model::none);
                if (even) tables_.emplace_back(memory, range_of(palette_.back().range));
            }
            zones_.push_back(zone);
        }
        classes_.push_back(colours);
    }
    def_.classes = classes_.data();
}

const char *ColourMap::keep(const char *text)
{
    if (!text) return nullptr;
    const size_t first = texts_.size();
    texts_.insert(texts_.end(), text, text + std::strlen(text) + 1);
    return texts_.data() + first;
}

ColourRecipe::ColourRecipe(std::pmr::memory_resource *memory, const ColourMap &map, uint32_t colour_class,
                           const model::Template &tmpl)
    : map_(map), own_(memory), zones_(memory)
{
    const clq_colour_map_def &def = map.def();
    if (colour_class >= def.class_count)
        fail(CLQ_ARGUMENT, "the map has no class %u: there are %u", colour_class, def.class_count);
    const clq_colour_class &colours = def.classes[colour_class];
    own_.reserve(tmpl.zone_count());
    for (const model::HsbRange &r : tmpl.zone_ranges)
        own_.push_back(
            {{r.hue_min_deg, r.hue_max_deg, r.saturation_min, r.saturation_max, r.brightness_min, r.brightness_max},
             1});
    for (uint32_t zone = 0; zone < tmpl.zone_count(); ++zone) zones_.push_back({&own_[zone], 1, false, zone, 0});
    // Zones that others are linked to come first, since the linked ones may take over their palettes.
    for (const bool linked : {false, true})
        for (uint32_t z = 0; z < colours.zone_count; ++z) {
            const clq_zone_colours &from = colours.zones[z];
            if ((from.linked_to != nullptr) != linked) continue;
            Zone &to = zones_[zone_named(tmpl, from.zone, colours)];
            if (linked) {
                const uint32_t leader = zone_named(tmpl, from.linked_to, colours);
                to = zones_[leader];
                to.variation = from.variation;
            }
            if (from.palette_count == 0) continue;
            to.palette = from.palette;
            to.palette_count = from.palette_count;
            to.of_map = true;
        }
}

uint32_t ColourRecipe::zone_named(const model::Template &tmpl, const char *name, const clq_colour_class &by) const
{
    for (uint32_t zone = 0; zone < tmpl.zone_count(); ++zone)
        if (tmpl.zone_names[zone] == name) return zone;
    fail(CLQ_ARGUMENT, "class '%s' names the zone '%s', and template '%s' has none%s", by.name, name, tmpl.name.c_str(),
         base::names_near(name, tmpl.zone_names).c_str());
}

void ColourRecipe::sample(uint32_t zone, uint64_t crowd_seed, uint64_t seed, double out_rgb[3]) const
{
    const Zone &from = zones_[zone];
    ColourSample sample(crowd_seed, seed, from.sample_zone);
    if (from.variation > 0) sample.vary(crowd_seed, seed, zone, double(from.variation));
    double sum = 0;
    for (uint32_t i = 0; i < from.palette_count; ++i) sum += double(from.palette[i].weight);
    double left = sample.entry * sum;
    uint32_t entry = 0;
    while (entry + 1 < from.palette_count && left >= double(from.palette[entry].weight))
        left -= double(from.palette[entry++].weight);
    const OklabSampler *even = from.of_map ? map_.oklab_sampler(from.palette + entry) : nullptr;
    rgb_of(even ? even->at(sample.hsb) : sample.in(range_of(from.palette[entry].range)), out_rgb);
}

}  // namespace claque::crowd
