#include "meshsplit/textures.h"

#include <algorithm>
#include <cmath>

#include "lib/base/error.h"
#include "lib/model/keys.h"
#include "meshsplit/cover.h"
#include "meshsplit/pyramid.h"

namespace claque::meshsplit
{

using model::none;
using model::Wrap;

namespace
{

uint8_t tinted(uint8_t value, float factor)
{
    return static_cast<uint8_t>(std::floor(std::clamp(float(value) * factor, 0.0f, 255.0f) + 0.5f));
}

ZoneMap palette_map(const TexturePlan &plan)
{
    const uint32_t side = palette_side(static_cast<uint32_t>(plan.cells.size()));
    ZoneMap map(side * cell_px, side * cell_px);
    for (uint32_t y = 0; y < map.height; ++y)
        for (uint32_t x = 0; x < map.width; ++x) {
            const size_t wanted = size_t(y / cell_px) * side + x / cell_px, at = size_t(y) * map.width + x;
            const Cell &cell = plan.cells[std::min(wanted, plan.cells.size() - 1)];
            map.zones[at] = cell.is_hole ? hole : static_cast<uint16_t>(cell.zone);
            for (size_t k = 0; k < 3; ++k) map.rgb[3 * at + k] = tinted(255, cell.rgb[k]);
        }
    return map;
}

// Maps the keys of a file to zones. Zones that materials name need no key of their own, so if several zones declare one
// key, those that no material names take precedence.
class KeyTable
{
public:
    explicit KeyTable(const model::Model &model) : model_(model), named_(model.zones.size())
    {
        for (const model::Material &material : model.materials)
            if (material.zone != none) named_[material.zone] = 1;
        zones_.fill(none);
        for (const uint8_t wanted : {0, 1})
            for (size_t z = 0; z < model.zones.size(); ++z)
                if (named_[z] == wanted) enter(static_cast<uint32_t>(z), wanted);
    }

    uint32_t zone(uint8_t key, const model::Image &image) const
    {
        if (clashes_[key])
            base::fail(CLQ_ARGUMENT, "image '%s' has key %u, which several zones declare, among them '%s'",
                       image.name.c_str(), key, model_.zones[zones_[key]].name.c_str());
        return zones_[key];
    }

private:
    void enter(uint32_t zone, uint8_t named)
    {
        const uint8_t key = model_.zones[zone].key;
        if (zones_[key] == none) zones_[key] = zone;
        else if (named_[zones_[key]] == named) clashes_[key] = true;
    }

    const model::Model &model_;
    std::vector<uint8_t> named_;
    std::array<uint32_t, 256> zones_{};
    std::array<bool, 256> clashes_{};
};

void read_keys(const model::Model &model, const model::Image &image, ZoneMap &map)
{
    const KeyTable table(model);
    std::array<size_t, 256> texels{};
    for (size_t i = 0; i < map.zones.size(); ++i) ++texels[image.rgba[4 * i + 3]];
    std::array<uint16_t, 256> zones{};
    for (size_t key = 0; key < 256; ++key) {
        if (texels[key] == 0) continue;
        const uint32_t zone = table.zone(static_cast<uint8_t>(key), image);
        if (zone == none)
            base::fail(CLQ_ARGUMENT, "image '%s' has key %zu in %zu texels, and no zone declares it",
                       image.name.c_str(), key, texels[key]);
        zones[key] = static_cast<uint16_t>(zone);
    }
    for (size_t i = 0; i < map.zones.size(); ++i) map.zones[i] = zones[image.rgba[4 * i + 3]];
}

struct Charts {
    std::vector<UvTriangle> triangles;
};

// By planned texture.
std::vector<Charts> charts_of(const Mesh &mesh, size_t plans)
{
    std::vector<Charts> charts(plans);
    for (const MeshTriangle &triangle : mesh.triangles) {
        UvTriangle uv;
        for (int k = 0; k < 3; ++k) uv.corners[k] = mesh.vertices[triangle.corners[static_cast<size_t>(k)]].uv;
        charts[mesh.surfaces[triangle.surface].texture].triangles.push_back(uv);
    }
    return charts;
}

Wrap gl_wrap(Wrap wrap) { return wrap == Wrap::clamp ? Wrap::clamp : Wrap::repeat; }

void fill_gutters(const TexturePlan &plan, const Charts &charts, ZoneMap &map)
{
    const TexelGrid grid{map.width, map.height, gl_wrap(plan.wrap_s), gl_wrap(plan.wrap_t)};
    // Spans are marked at their ends, so that a triangle costs its rows and not its texels.
    std::vector<int32_t> ends((size_t(map.width) + 1) * map.height);
    std::vector<TexelSpan> spans;
    for (const UvTriangle &triangle : charts.triangles) {
        spans.clear();
        cover(grid, triangle, spans);
        for (const TexelSpan &span : spans) {
            int32_t *row = ends.data() + size_t(span.row) * (size_t(map.width) + 1);
            ++row[span.first], --row[span.first + span.count];
        }
    }
    std::vector<uint8_t> covered;
    covered.reserve(map.zones.size());
    for (uint32_t y = 0; y < map.height; ++y)
        for (int64_t x = 0, open = 0; x < int64_t(map.width); ++x) {
            open += ends[size_t(y) * (size_t(map.width) + 1) + size_t(x)];
            covered.push_back(open > 0);
        }
    dilate(map, covered);
}

ZoneMap final_map(const model::Model &model, const TexturePlan &plan, const Charts &charts, uint32_t image,
                  uint32_t max_px)
{
    ZoneMap map = source_map(model, plan, image);
    if (image == none) return map;
    if (plan.wrap_s == Wrap::mirror || plan.wrap_t == Wrap::mirror)
        map = unfold(map, plan.wrap_s == Wrap::mirror, plan.wrap_t == Wrap::mirror);
    // Gutters matter for resizing and if there is more than one zone.
    const bool plain = plan.zone != none && !plan.masked && fits(map, max_px);
    if (!plain) fill_gutters(plan, charts, map);
    return fit(map, max_px);
}

// Returns the zones of a texture in all its sets, by key if the file has keys, else in the model's order.
std::vector<uint32_t> zones_of(const std::vector<ZoneMap> &maps, const MaterialPlan &materials, const TexturePlan &plan)
{
    std::vector<uint8_t> present(materials.zones.size());
    for (const ZoneMap &map : maps)
        for (const uint16_t zone : map.zones)
            if (zone != hole) present[zone] = 1;
    std::vector<uint32_t> zones;
    for (uint32_t z = 0; z < present.size(); ++z)
        if (present[z]) zones.push_back(z);
    if (zones.empty()) zones.push_back(plan.image == none ? plan.cells[0].zone : plan.zone);
    if (plan.zone == none && plan.image != none)
        std::stable_sort(zones.begin(), zones.end(),
                         [&](uint32_t a, uint32_t b) { return materials.zones[a].key < materials.zones[b].key; });
    return zones;
}

// Returns whether there is a hole.
bool encode(const ZoneMap &map, const model::Array<model::ZoneKey> &keys, model::Array<uint8_t> &rgba)
{
    std::vector<uint8_t> key_of(size_t(hole) + 1);
    for (const model::ZoneKey &key : keys) key_of[key.zone] = key.key;
    bool has_holes = false;
    rgba.resize(4 * map.zones.size());
    for (size_t i = 0; i < map.zones.size(); ++i) {
        for (size_t k = 0; k < 3; ++k) rgba[4 * i + k] = map.rgb[3 * i + k];
        rgba[4 * i + 3] = map.zones[i] == hole ? 0 : key_of[map.zones[i]];
        has_holes = has_holes || map.zones[i] == hole;
    }
    return has_holes;
}

// Returns the maps of all texture sets, the first one first; a single map if all are equal.
std::vector<ZoneMap> maps_of(const model::Model &model, const TexturePlan &plan, const Charts &charts, uint32_t max_px)
{
    std::vector<ZoneMap> maps = {final_map(model, plan, charts, plan.image, max_px)};
    const auto differs = [](uint32_t image) { return image != none; };
    if (std::none_of(plan.others.begin(), plan.others.end(), differs)) return maps;
    for (const uint32_t image : plan.others)
        maps.push_back(image == none ? maps[0] : final_map(model, plan, charts, image, max_px));
    return maps;
}

void make_texture(const std::vector<ZoneMap> &maps, const MaterialPlan &materials, const TexturePlan &plan,
                  model::Texture &out)
{
    const std::vector<uint32_t> zones = zones_of(maps, materials, plan);
    const std::vector<uint8_t> keys = model::geometric_keys(static_cast<uint32_t>(zones.size()));
    for (size_t i = 0; i < zones.size(); ++i) out.keys.push_back({zones[i], keys[i]});
    out.width = maps[0].width, out.height = maps[0].height;
    out.wrap_s = gl_wrap(plan.wrap_s), out.wrap_t = gl_wrap(plan.wrap_t);
    out.has_holes = encode(maps[0], out.keys, out.rgba);
    for (size_t i = 1; i < maps.size(); ++i) {
        model::TextureImage &other = out.set_images.emplace_back(out.set_images.get_allocator().resource());
        other.width = maps[i].width, other.height = maps[i].height;
        out.has_holes = encode(maps[i], out.keys, other.rgba) || out.has_holes;
    }
}

}  // namespace

ZoneMap source_map(const model::Model &model, const TexturePlan &plan, uint32_t image_index)
{
    if (image_index == none) return palette_map(plan);
    const model::Image &image = model.images[image_index];
    ZoneMap map(image.width, image.height);
    for (size_t i = 0; i < map.zones.size(); ++i) {
        for (size_t k = 0; k < 3; ++k) map.rgb[3 * i + k] = tinted(image.rgba[4 * i + k], plan.rgb[k]);
        const bool is_hole = plan.masked && float(image.rgba[4 * i + 3]) / 255.0f < plan.cutoff;
        map.zones[i] = is_hole ? hole : static_cast<uint16_t>(plan.zone);
    }
    if (plan.zone == none) read_keys(model, image, map);
    return map;
}

std::vector<uint32_t> make_textures(const model::Model &model, const MaterialPlan &materials, uint32_t max_texture_px,
                                    const Mesh &mesh, model::Array<model::Texture> &out)
{
    std::vector<uint32_t> made(materials.textures.size(), none);
    const std::vector<Charts> charts = charts_of(mesh, materials.textures.size());
    for (const MeshSurface &surface : mesh.surfaces) {
        uint32_t &texture = made[surface.texture];
        if (texture != none) continue;
        const TexturePlan &plan = materials.textures[surface.texture];
        const std::vector<ZoneMap> maps = maps_of(model, plan, charts[surface.texture], max_texture_px);
        texture = static_cast<uint32_t>(out.size());
        out.emplace_back(out.get_allocator().resource());
        make_texture(maps, materials, plan, out.back());
    }
    return made;
}

}  // namespace claque::meshsplit
