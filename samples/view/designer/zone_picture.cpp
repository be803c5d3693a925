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

// By zone of the template.
std::vector<Rgb> colours_of(const clq_template *tmpl, const ColourClass *colours, const std::string &chosen)
{
    clq_template_info info = clq_template_info_init();
    scenes::check(clq_template_get_info(tmpl, &info));
    std::vector<Rgb> all;
    for (uint32_t k = 0; k < info.zone_count; ++k) {
        clq_zone_info zone = clq_zone_info_init();
        scenes::check(clq_template_get_zone(tmpl, k, &zone));
        float rgb[3] = {zone.colour[0], zone.colour[1], zone.colour[2]};
        const ZoneColours *own = colours ? colours->find(zone.name) : nullptr;
        if (own && own->palette.empty()) own = colours->find(own->linked_to);
        if (own && !own->palette.empty()) rgb_of(own->palette[0].range, rgb);
        const float light = chosen == zone.name ? 1 : others;
        all.push_back({rgb[0] * light, rgb[1] * light, rgb[2] * light});
    }
    return all;
}

void compose(ZonePicture &out, const std::vector<uint8_t> &light)
{
    const std::vector<Rgb> colours = colours_of(out.tmpl, out.colours.get(), out.zone);
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

}  // namespace

uint32_t ZonePicture::at(float u, float v) const
{
    const auto place = [](float share, uint32_t count) {
        return std::min(count - 1, static_cast<uint32_t>(std::max(0.0f, share) * static_cast<float>(count)));
    };
    return width_px == 0 ? CLQ_NONE : zones[static_cast<size_t>(place(v, height_px)) * width_px + place(u, width_px)];
}

std::shared_ptr<const ZonePicture> picture_of(const clq_template *tmpl, const Designer &designer,
                                              const std::shared_ptr<const ZonePicture> &last)
{
    SharedClass colours;
    const ColourClass *chosen = chosen_class(designer);
    for (const SharedClass &one : designer.design.classes)
        if (one.get() == chosen) colours = one;
    const auto worn = designer.sets.find(designer.tmpl);
    const uint32_t set = worn == designer.sets.end() ? 0 : worn->second;
    if (last && last->tmpl == tmpl && last->set == set && last->texture == designer.texture &&
        last->colours == colours && last->zone == designer.zone)
        return last;
    clq_texels texels = clq_texels_init();
    if (clq_template_get_texture(tmpl, set, designer.texture, &texels) != CLQ_OK) return nullptr;
    auto made = std::make_shared<ZonePicture>();
    made->tmpl = tmpl, made->set = set, made->texture = designer.texture;
    made->colours = colours, made->zone = designer.zone;
    made->width_px = texels.width_px, made->height_px = texels.height_px;
    made->number = (last ? last->number : 0) + 1;
    texels.capacity = static_cast<size_t>(texels.width_px) * texels.height_px;
    made->zones.resize(texels.capacity);
    std::vector<uint8_t> light(3 * texels.capacity);
    texels.rgb = light.data(), texels.zones = made->zones.data();
    scenes::check(clq_template_get_texture(tmpl, set, designer.texture, &texels));
    compose(*made, light);
    return made;
}

}  // namespace view
