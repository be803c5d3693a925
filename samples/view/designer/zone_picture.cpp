#include "samples/view/designer/zone_picture.h"

#include <algorithm>

namespace view
{
namespace
{

constexpr int most_side_px = 512;
constexpr float others = 0.4f;  // how bright zones are that are not chosen

struct Rgb {
    float r, g, b;
};

struct Named {
    std::vector<std::string> names;
    std::vector<clq_zone_info> zones;
};

Named zones_of(const clq_template *tmpl)
{
    clq_template_info info = clq_template_info_init();
    scenes::check(clq_template_get_info(tmpl, &info));
    Named all;
    for (uint32_t k = 0; k < info.zone_count; ++k) {
        clq_zone_info zone = clq_zone_info_init();
        scenes::check(clq_template_get_zone(tmpl, k, &zone));
        all.names.emplace_back(zone.name);
        all.zones.push_back(zone);
    }
    return all;
}

std::vector<Rgb> colours_of(const ZonePicture &picture)
{
    const Named own = zones_of(picture.tmpl);
    std::vector<Rgb> all;
    for (const std::string &name : picture.names) {
        float rgb[3] = {0.8f, 0.8f, 0.8f};
        for (size_t k = 0; k < own.names.size(); ++k)
            if (own.names[k] == name) std::copy(own.zones[k].colour, own.zones[k].colour + 3, rgb);
        const ZoneColours *worn = picture.colours ? picture.colours->find(name) : nullptr;
        if (worn && worn->palette.empty()) worn = picture.colours->find(worn->linked_to);
        if (worn && !worn->palette.empty()) rgb_of(worn->palette[0].range, rgb);
        const float light = picture.zone == name ? 1 : others;
        all.push_back({rgb[0] * light, rgb[1] * light, rgb[2] * light});
    }
    return all;
}

void compose(ZonePicture &out)
{
    const std::vector<uint8_t> &light = *out.light;
    const std::vector<Rgb> colours = colours_of(out);
    out.side_px = 64;
    while (out.side_px < most_side_px && out.side_px < static_cast<int>(std::max(out.width_px, out.height_px)))
        out.side_px *= 2;
    const auto side = static_cast<size_t>(out.side_px);
    out.rgba.assign(4 * side * side, 255);
    for (size_t y = 0; y < side; ++y)
        for (size_t x = 0; x < side; ++x) {
            const size_t from = (y * out.height_px / side) * out.width_px + x * out.width_px / side;
            const uint32_t zone = out.zones[from];
            const Rgb colour = zone < colours.size() ? colours[zone] : Rgb{0.1f, 0.1f, 0.1f};
            uint8_t *to = out.rgba.data() + 4 * (y * side + x);
            const float rgb[3] = {colour.r, colour.g, colour.b};
            for (size_t k = 0; k < 3; ++k)
                to[k] = static_cast<uint8_t>(static_cast<float>(light[3 * from + k]) * std::min(rgb[k], 1.0f) + 0.5f);
        }
}

// Returns false if the template lacks the texture.
bool take_texture(ZonePicture &out)
{
    clq_texels texels = clq_texels_init();
    if (clq_template_get_texture(out.tmpl, out.set, out.texture, &texels) != CLQ_OK) return false;
    out.width_px = texels.width_px, out.height_px = texels.height_px;
    texels.capacity = static_cast<size_t>(texels.width_px) * texels.height_px;
    out.zones.resize(texels.capacity);
    std::vector<uint8_t> light(3 * texels.capacity);
    texels.rgb = light.data(), texels.zones = out.zones.data();
    scenes::check(clq_template_get_texture(out.tmpl, out.set, out.texture, &texels));
    out.light = std::make_shared<const std::vector<uint8_t>>(std::move(light));
    out.names = zones_of(out.tmpl).names;
    return true;
}

}  // namespace

std::string ZonePicture::at(float u, float v) const
{
    const auto place = [](float share, uint32_t count) {
        return std::min(count - 1, static_cast<uint32_t>(std::max(0.0f, share) * static_cast<float>(count)));
    };
    if (width_px == 0) return "";
    const uint32_t zone = zones[static_cast<size_t>(place(v, height_px)) * width_px + place(u, width_px)];
    return zone < names.size() ? names[zone] : "";
}

std::shared_ptr<ZoneMap> ZonePicture::painted() const
{
    if (map) return std::make_shared<ZoneMap>(*map);
    auto made = std::make_shared<ZoneMap>(width_px, height_px);
    made->tmpl = owner;
    made->texture_set = set, made->texture = texture;
    made->light = light;
    const Named own = zones_of(tmpl);
    for (size_t k = 0; k < own.names.size() && k < ZoneMap::none; ++k) {
        made->names.push_back(own.names[k]);
        made->ranges.push_back(own.zones[k].range);
    }
    for (uint32_t y = 0; y < height_px; ++y)
        for (uint32_t x = 0; x < width_px; ++x) {
            const uint32_t zone = zones[static_cast<size_t>(y) * width_px + x];
            if (zone < made->names.size()) made->set(x, y, static_cast<uint8_t>(zone));
        }
    return made;
}

std::shared_ptr<const ZonePicture> picture_of(const clq_template *tmpl, const Designer &designer,
                                              const std::shared_ptr<const ZonePicture> &last)
{
    SharedClass colours;
    const ColourClass *chosen = chosen_class(designer);
    for (const SharedClass &one : designer.design.classes)
        if (one.get() == chosen) colours = one;
    const uint32_t set = shown_set(designer);
    const SharedMap map = painted_map(designer);
    if (last && last->tmpl == tmpl && last->set == set && last->texture == designer.texture &&
        last->colours == colours && last->zone == designer.zone && last->map == map)
        return last;
    auto made = std::make_shared<ZonePicture>();
    made->tmpl = tmpl, made->set = set, made->texture = designer.texture;
    made->owner = designer.tmpl;
    made->colours = colours, made->zone = designer.zone, made->map = map;
    made->number = (last ? last->number : 0) + 1;
    if (map) {
        made->width_px = map->width(), made->height_px = map->height();
        made->names = map->names, made->light = map->light;
        for (uint32_t y = 0; y < map->height(); ++y)
            for (uint32_t x = 0; x < map->width(); ++x) made->zones.push_back(map->at(x, y));
    } else if (!take_texture(*made)) return nullptr;
    compose(*made);
    return made;
}

}  // namespace view
