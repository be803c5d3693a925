#include "samples/view/designer/painting.h"

#include <algorithm>
#include <cmath>

namespace view
{
namespace
{

// Changes the painted map, or begins one with the zones that the template has.
template <class Change>
void paint(Designer &d, const std::string &by, const Change &change)
{
    const std::shared_ptr<ZoneMap> map = d.picture->painted();
    const uint8_t zone = map->zone(d.zone);
    if (zone == ZoneMap::none) return;
    change(*map, zone);
    if (d.picture->map && *map == *d.picture->map) return;
    set_zone_map(d, map, by);
}

void use_tool(Designer &d, const clq_template *tmpl, float u, float v)
{
    Brush &brush = d.brush;
    const bool begins = !brush.held;
    brush.held = true;
    if (begins) brush.last[0] = u, brush.last[1] = v;
    if (brush.tool == BrushTool::pick) {
        const std::string zone = d.picture->at(u, v);
        if (!zone.empty() && zone != d.zone) d.zone = zone, d.entry = 0;
    } else if (brush.tool == BrushTool::brush) {
        const float to[2] = {u, v};
        if (begins || u != brush.last[0] || v != brush.last[1])
            paint(d, "brush",
                  [&](ZoneMap &map, uint8_t zone) { stroke(map, zone, brush.last, to, brush.diameter_px); });
    } else if (begins) paint(d, "fill", [&](ZoneMap &map, uint8_t zone) { fill_island(map, zone, tmpl, u, v); });
    brush.last[0] = u, brush.last[1] = v;
}

void tools(Ui &ui, Designer &d)
{
    Brush &brush = d.brush;
    int tool = static_cast<int>(brush.tool);
    if (ui.choice("tool", tool, {"pick", "brush", "fill"})) brush.tool = static_cast<BrushTool>(tool);
    if (brush.tool == BrushTool::pick) return;
    ui.number("brush size", brush.diameter_px, 1, 256, "%.0f", 0.2f);
    ui.text_field("new zone", brush.name);
    if (ui.button("add zone") && !brush.name.empty()) d.zone = brush.name, d.entry = 0;
    if (ui.button("save zones", true)) d.wishes.save_zones = true;
    ui.number("zones at most", brush.most_zones, 1, 48, "%.0f", 0.1f);
    if (ui.button("propose zones")) d.wishes.propose = true;
    const SharedMap map = painted_map(d);
    if (!map) return;
    bool grey = map->reduced;
    if (!ui.toggle("grey texels", grey, true)) return;
    const std::shared_ptr<ZoneMap> made = std::make_shared<ZoneMap>(*map);
    made->reduced = grey;
    set_zone_map(d, made, "");
}

}  // namespace

void texture_of_zones(Ui &ui, Designer &designer, const clq_template *tmpl, bool paintable)
{
    designer.picture = picture_of(tmpl, designer, designer.picture);
    if (!designer.picture) return;
    const std::shared_ptr<const ZonePicture> shown = designer.picture;
    float u = 0, v = 0;
    if (ui.picture("texels", shown->rgba.data(), shown->side_px, shown->number, 14 * ui.em(), u, v))
        use_tool(designer, tmpl, u, v);
    else designer.brush.held = false;
    if (paintable) tools(ui, designer);
    else designer.brush.tool = BrushTool::pick;
}

uint32_t image_for(const clq_asset *asset, const ZoneMap &map)
{
    clq_asset_info info = clq_asset_info_init();
    scenes::check(clq_asset_get_info(asset, &info));
    constexpr uint32_t samples = 64;
    double least = 40;  // of 255, in the mean
    uint32_t best = CLQ_NONE;
    for (uint32_t k = 0; k < info.image_count; ++k) {
        clq_asset_image image = clq_asset_image_init();
        scenes::check(clq_asset_get_image(asset, k, &image));
        double differs = 0;
        for (uint32_t place = 0; place < samples * samples; ++place) {
            const auto texel = [&](uint32_t width, uint32_t height) {
                const uint32_t x = (2 * (place % samples) + 1) * width / (2 * samples);
                const uint32_t y = (2 * (place / samples) + 1) * height / (2 * samples);
                return static_cast<size_t>(y) * width + x;
            };
            const uint8_t *a = image.rgba + 4 * texel(image.width_px, image.height_px);
            const uint8_t *b = map.light->data() + 3 * texel(map.width(), map.height());
            for (size_t c = 0; c < 3; ++c) differs += std::abs(a[c] - b[c]);
        }
        differs /= 3.0 * samples * samples;
        if (differs >= least) continue;
        least = differs;
        best = k;
    }
    if (best == CLQ_NONE)
        throw scenes::Failure("no image of '" + map.tmpl + "' is like the texture that was painted over");
    return best;
}

void give_zones(clq_context *context, clq_asset *asset, const ZoneMap &map)
{
    std::vector<clq_zone_map_zone> zones;
    for (size_t k = 0; k < map.names.size(); ++k)
        zones.push_back({map.names[k].c_str(), map.reduced, k < map.ranges.size() ? &map.ranges[k] : nullptr});
    const std::vector<uint16_t> texels = texels_of(map);
    clq_zone_map_def def = clq_zone_map_def_init();
    def.image = image_for(asset, map);
    def.width_px = map.width(), def.height_px = map.height();
    def.texels = texels.data();
    def.zone_count = static_cast<uint32_t>(zones.size());
    def.zones = zones.data();
    scenes::check(clq_asset_set_zone_map(context, asset, &def));
}

SharedMap proposed(const clq_asset *asset, const ZoneMap &over, uint32_t most_zones)
{
    const uint32_t number = image_for(asset, over);
    clq_asset_image image = clq_asset_image_init();
    scenes::check(clq_asset_get_image(asset, number, &image));
    std::vector<uint16_t> texels(static_cast<size_t>(image.width_px) * image.height_px);
    std::vector<uint8_t> means(3 * static_cast<size_t>(most_zones));
    clq_zone_proposal proposal = clq_zone_proposal_init();
    proposal.max_zones = most_zones;
    proposal.texels = texels.data(), proposal.capacity_texels = texels.size();
    proposal.rgb = means.data();
    scenes::check(clq_asset_propose_zones(asset, number, &proposal));
    const auto made = std::make_shared<ZoneMap>(over.width(), over.height());
    made->tmpl = over.tmpl, made->texture_set = over.texture_set, made->texture = over.texture;
    made->light = over.light;
    made->reduced = true;
    for (uint32_t k = 0; k < proposal.zone_count; ++k) made->names.push_back("zone " + std::to_string(k + 1));
    for (uint32_t y = 0; y < over.height(); ++y)
        for (uint32_t x = 0; x < over.width(); ++x) {
            const size_t from = static_cast<size_t>(y) * image.height_px / over.height() * image.width_px +
                                static_cast<size_t>(x) * image.width_px / over.width();
            if (texels[from] < proposal.zone_count) made->set(x, y, static_cast<uint8_t>(texels[from]));
        }
    return made;
}

}  // namespace view
