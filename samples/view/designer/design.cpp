#include "samples/view/designer/design.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace view
{
namespace
{

// A map's definition; `def` points into the design and into the other members.
struct Defined {
    explicit Defined(const Design &design)
    {
        for (const SharedClass &one : design.classes) {
            std::vector<clq_zone_colours> &of_class = zones.emplace_back();
            for (const ZoneColours &zone : one->zones)
                of_class.push_back({zone.zone.c_str(), static_cast<uint32_t>(zone.palette.size()), zone.palette.data(),
                                    zone.space, zone.linked_to.empty() ? nullptr : zone.linked_to.c_str(),
                                    zone.variation});
        }
        for (size_t k = 0; k < zones.size(); ++k) {
            const ColourClass &one = *design.classes[k];
            classes.push_back({one.name.c_str(), one.tmpl ? one.tmpl->c_str() : nullptr,
                               static_cast<uint32_t>(zones[k].size()), zones[k].data()});
        }
        def.class_count = static_cast<uint32_t>(classes.size());
        def.classes = classes.data();
    }

    clq_colour_map_def def = clq_colour_map_def_init();
    std::vector<std::vector<clq_zone_colours>> zones;
    std::vector<clq_colour_class> classes;
};

Design design_of(const clq_colour_map *map)
{
    clq_colour_map_def def = clq_colour_map_def_init();
    scenes::check(clq_colour_map_get_def(map, &def));
    Design design;
    for (uint32_t c = 0; c < def.class_count; ++c) {
        const clq_colour_class &from = def.classes[c];
        ColourClass made;
        made.name = from.name;
        if (from.tmpl) made.tmpl = from.tmpl;
        for (uint32_t z = 0; z < from.zone_count; ++z) {
            const clq_zone_colours &zone = from.zones[z];
            ZoneColours colours = {
                zone.zone, {}, zone.colour_space, zone.linked_to ? zone.linked_to : "", zone.variation};
            colours.palette.assign(zone.palette, zone.palette + zone.palette_count);
            made.zones.push_back(std::move(colours));
        }
        design.classes.push_back(std::make_shared<const ColourClass>(std::move(made)));
    }
    return design;
}

}  // namespace

const ZoneColours *ColourClass::find(const std::string &zone) const
{
    for (const ZoneColours &one : zones)
        if (one.zone == zone) return &one;
    return nullptr;
}

ZoneColours *ColourClass::find(const std::string &zone)
{
    return const_cast<ZoneColours *>(static_cast<const ColourClass *>(this)->find(zone));
}

bool same(const clq_hsb_range &a, const clq_hsb_range &b)
{
    return a.hue_min_deg == b.hue_min_deg && a.hue_max_deg == b.hue_max_deg && a.saturation_min == b.saturation_min &&
           a.saturation_max == b.saturation_max && a.brightness_min == b.brightness_min &&
           a.brightness_max == b.brightness_max;
}

bool operator==(const ZoneColours &a, const ZoneColours &b)
{
    return a.zone == b.zone && a.space == b.space && a.linked_to == b.linked_to && a.variation == b.variation &&
           std::equal(a.palette.begin(), a.palette.end(), b.palette.begin(), b.palette.end(),
                      [](const clq_palette_entry &x, const clq_palette_entry &y) {
                          return x.weight == y.weight && same(x.range, y.range);
                      });
}

bool operator==(const ColourClass &a, const ColourClass &b)
{
    return a.name == b.name && a.tmpl == b.tmpl && a.zones == b.zones;
}

bool operator==(const Design &a, const Design &b)
{
    return std::equal(a.classes.begin(), a.classes.end(), b.classes.begin(), b.classes.end(),
                      [](const SharedClass &x, const SharedClass &y) { return x == y || *x == *y; }) &&
           std::equal(a.maps.begin(), a.maps.end(), b.maps.begin(), b.maps.end(),
                      [](const SharedMap &x, const SharedMap &y) { return x == y || *x == *y; });
}

scenes::ColourMap map_of(clq_context *context, const Design &design)
{
    const Defined defined(design);
    clq_colour_map *map = nullptr;
    scenes::check(clq_colour_map_create(context, &defined.def, &map));
    return scenes::ColourMap(map);
}

Design read_design(clq_context *context, const std::string &toml, const std::string &where)
{
    clq_colour_map *map = nullptr;
    scenes::check(clq_colour_map_load(context, toml.data(), toml.size(), where.c_str(), &map));
    return design_of(scenes::ColourMap(map).get());
}

std::string design_text(clq_context *context, const Design &design)
{
    if (design.classes.empty()) throw scenes::Failure("there is no colour class to save yet");
    const scenes::ColourMap map = map_of(context, design);
    std::string text;
    const auto take = [](void *to, const void *bytes, size_t count) {
        static_cast<std::string *>(to)->append(static_cast<const char *>(bytes), count);
        return 0;
    };
    scenes::check(clq_colour_map_save(map.get(), take, &text));
    return text;
}

// The library reads it, so that a colour typed here and one in a file are the same range to the bit.
std::optional<clq_hsb_range> range_of_hex(clq_context *context, const std::string &text)
{
    if (text.size() != 7 || text[0] != '#' || text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos)
        return {};
    const std::string toml = "[[classes]]\nname = \"c\"\n[classes.zones]\nz = { colour = \"" + text + "\" }\n";
    return read_design(context, toml, text).classes[0]->zones[0].palette[0].range;
}

float middle_hue_deg(const clq_hsb_range &range)
{
    const float width = range.hue_max_deg - range.hue_min_deg + (range.hue_min_deg > range.hue_max_deg ? 360.0f : 0.0f);
    return range.hue_min_deg + width / 2;
}

void rgb_of(const clq_hsb_range &range, float (&out)[3])
{
    const float hue = middle_hue_deg(range) / 360, s = (range.saturation_min + range.saturation_max) / 2,
                b = (range.brightness_min + range.brightness_max) / 2;
    // Each channel is full for a third of the circle about its own hue and falls off over a sixth on both sides.
    for (int channel = 0; channel < 3; ++channel) {
        float away = std::fabs(hue - std::floor(hue) - static_cast<float>(channel) / 3);
        if (away > 0.5f) away = 1 - away;
        out[channel] = b * (1 - s * (1 - std::clamp(2 - 6 * away, 0.0f, 1.0f)));
    }
}

std::string hex_of(const clq_hsb_range &range)
{
    float rgb[3];
    rgb_of(range, rgb);
    char text[16];
    const auto byte = [&](int k) { return static_cast<unsigned>(std::lround(std::clamp(rgb[k], 0.0f, 1.0f) * 255)); };
    std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(0), byte(1), byte(2));
    return text;
}

}  // namespace view
