#include "tests/gl/support/posed_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "lib/base/hash.h"
#include "lib/model/keys.h"

namespace gltest
{
namespace
{

std::set<uint32_t> zones_of(const Mesh &mesh, const std::array<uint32_t, 3> &t, const ZoneMap &map)
{
    const float side = static_cast<float>(map.side);
    glm::vec2 low(1e9f), high(-1e9f);
    for (const uint32_t v : t) low = glm::min(low, mesh.uvs[v] * side), high = glm::max(high, mesh.uvs[v] * side);
    std::set<uint32_t> zones;
    for (int y = int(std::floor(low.y - 0.01f)); y <= int(std::floor(high.y + 0.01f)); ++y)
        for (int x = int(std::floor(low.x - 0.01f)); x <= int(std::floor(high.x + 0.01f)); ++x) {
            const uint32_t wx = uint32_t(x + int(map.side)) % map.side, wy = uint32_t(y + int(map.side)) % map.side;
            if (map.zones[wy * map.side + wx] != hole) zones.insert(map.zones[wy * map.side + wx]);
        }
    if (zones.empty()) zones.insert(0);  // only holes: any zone serves
    return zones;
}

// Vertices by (source, slot): a source vertex serves its first slot, copies serve the others.
class Slots
{
public:
    explicit Slots(model::Level &level) : level_(level), taken_(level.source_count, false)
    {
        level_.slots.assign(level.source_count, 0);
    }
    uint32_t vertex(uint32_t source, uint16_t slot)
    {
        if (!taken_[source]) {
            taken_[source] = true;
            level_.slots[source] = slot;
        }
        if (level_.slots[source] == slot) return source;
        const auto found = copies_.find({source, slot});
        if (found != copies_.end()) return found->second;
        const uint32_t made = level_.source_count + static_cast<uint32_t>(level_.copies.size());
        level_.copies.push_back(source);
        level_.slots.push_back(slot);
        return copies_[{source, slot}] = made;
    }

private:
    model::Level &level_;
    std::vector<bool> taken_;
    std::map<std::pair<uint32_t, uint16_t>, uint32_t> copies_;
};

// Triangles with their parts.
struct Pieces {
    std::vector<std::array<uint32_t, 3>> triangles;
    std::vector<uint32_t> parts;
    void push_back(const std::array<uint32_t, 3> &triangle, uint32_t part)
    {
        triangles.push_back(triangle);
        parts.push_back(part);
    }
};

// Part by part, `pieces` in order within each.
class Ranges
{
public:
    Ranges(model::Level &level, model::Surface &surface, uint32_t part_count)
        : level_(level), surface_(surface), part_count_(part_count)
    {
    }
    model::IndexRange add(std::initializer_list<const Pieces *> pieces)
    {
        const uint32_t first = static_cast<uint32_t>(level_.indices.size());
        const auto here = [&] { return static_cast<uint32_t>(level_.indices.size()) - first; };
        for (uint32_t part = 0; part < part_count_; ++part) {
            if (part_count_ > 1) surface_.part_offsets.push_back(here());
            for (const Pieces *some : pieces)
                for (size_t i = 0; i < some->parts.size(); ++i)
                    if (some->parts[i] == part)
                        level_.indices.insert(level_.indices.end(), some->triangles[i].begin(),
                                              some->triangles[i].end());
        }
        if (part_count_ > 1) surface_.part_offsets.push_back(here());
        return {first, here()};
    }

private:
    model::Level &level_;
    model::Surface &surface_;
    uint32_t part_count_;
};

void add_surface(model::Level &level, const Mesh &mesh, const ZoneMap &map, uint32_t surface_index, Slots &slots)
{
    model::Surface &surface = level.surfaces.emplace_back(level.indices.get_allocator().resource());
    std::vector<Pieces> clean(map.zone_count), by_zone(map.zone_count);
    Pieces dirty, fused_clean, fused_dirty;
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (!mesh.surfaces.empty() && mesh.surfaces[i] != surface_index) continue;
        const std::array<uint32_t, 3> &t = mesh.triangles[i];
        const uint32_t part = mesh.parts.empty() ? 0 : mesh.parts[i];
        const std::set<uint32_t> zones = zones_of(mesh, t, map);
        const bool is_clean = zones.size() == 1;
        if (!is_clean) dirty.push_back(t, part);
        for (const uint32_t zone : zones) {
            (is_clean ? clean : by_zone)[zone].push_back(t, part);
            const uint16_t slot = static_cast<uint16_t>(2 * zone + (zone == *zones.begin() ? 0 : 1));
            (is_clean ? fused_clean : fused_dirty)
                .push_back({slots.vertex(t[0], slot), slots.vertex(t[1], slot), slots.vertex(t[2], slot)}, part);
        }
    }
    Ranges ranges(level, surface, mesh.part_count);
    for (uint32_t zone = 0; zone < map.zone_count; ++zone)
        if (!clean[zone].parts.empty()) surface.clean.push_back({zone, ranges.add({&clean[zone]})});
    surface.dirty = ranges.add({&dirty});
    for (uint32_t zone = 0; zone < map.zone_count; ++zone)
        if (!by_zone[zone].parts.empty()) surface.dirty_by_zone.push_back({zone, ranges.add({&by_zone[zone]})});
    surface.fused = ranges.add({&fused_clean, &fused_dirty});
}

void add_texture(model::Template &tmpl, const ZoneMap &map)
{
    model::Texture &texture = tmpl.textures.emplace_back(std::pmr::get_default_resource());
    const std::vector<uint8_t> keys = model::geometric_keys(map.zone_count);
    texture.width = texture.height = map.side;
    for (uint32_t zone = 0; zone < map.zone_count; ++zone) texture.keys.push_back({zone, keys[zone]});
    for (const uint16_t zone : map.zones) {
        texture.has_holes = texture.has_holes || zone == hole;
        for (int c = 0; c < 3; ++c) texture.rgba.push_back(255);
        texture.rgba.push_back(zone == hole ? 0 : keys[zone]);
    }
}

}  // namespace

PosedModel make_posed(const Mesh &mesh, const ZoneMap &map)
{
    auto tmpl = std::make_unique<model::Template>(std::pmr::get_default_resource());
    tmpl->name = "hand-made";
    const std::vector<uint8_t> colours = zone_colours(map.zone_count);
    for (uint32_t zone = 0; zone < map.zone_count; ++zone) {
        tmpl->zone_names.emplace_back("zone");
        const uint8_t *c = &colours[3 * zone];
        tmpl->zone_colours.push_back({c[0] / 255.0f, c[1] / 255.0f, c[2] / 255.0f});
    }
    add_texture(*tmpl, map);
    model::Level &level = tmpl->levels.emplace_back(std::pmr::get_default_resource());
    level.source_count = static_cast<uint32_t>(mesh.positions.size());
    for (const glm::vec3 &p : mesh.positions) level.positions.insert(level.positions.end(), {p.x, p.y, p.z});
    for (const glm::vec3 &n : mesh.normals) level.normals.insert(level.normals.end(), {n.x, n.y, n.z});
    Slots slots(level);
    for (uint32_t i = 0; i < mesh.surface_count; ++i) add_surface(level, mesh, map, i, slots);
    level.vertex_count = level.source_count + static_cast<uint32_t>(level.copies.size());
    for (uint32_t v = 0; v < level.vertex_count; ++v) {
        const uint32_t source = v < level.source_count ? v : level.copies[v - level.source_count];
        level.uvs.insert(level.uvs.end(), {mesh.uvs[source].x, mesh.uvs[source].y});
        if (!mesh.colours.empty())
            level.colours.insert(level.colours.end(), mesh.colours[source].begin(), mesh.colours[source].end());
    }
    return take_posed(std::move(tmpl));
}

PosedModel take_posed(std::unique_ptr<model::Template> tmpl)
{
    PosedModel posed;
    const model::Level &level = tmpl->levels[0];
    posed.positions.assign(level.positions.begin(), level.positions.end());
    posed.normals.assign(level.normals.begin(), level.normals.end());
    for (const uint32_t source : level.copies)
        for (int c = 0; c < 3; ++c) {
            posed.positions.push_back(level.positions[3 * source + c]);
            posed.normals.push_back(level.normals[3 * source + c]);
        }
    measure(posed);
    posed.tmpl = std::move(tmpl);
    return posed;
}

void measure(PosedModel &posed)
{
    glm::vec3 low(1e30f), high(-1e30f);
    for (size_t i = 0; i < posed.positions.size(); i += 3) {
        const glm::vec3 p(posed.positions[i], posed.positions[i + 1], posed.positions[i + 2]);
        low = glm::min(low, p), high = glm::max(high, p);
    }
    posed.centre = 0.5f * (low + high);
    posed.radius = std::max(0.5f * glm::length(high - low), 1e-6f);
}

Mesh sheet(uint32_t cells, float waves)
{
    Mesh mesh;
    for (uint32_t y = 0; y <= cells; ++y)
        for (uint32_t x = 0; x <= cells; ++x) {
            const glm::vec2 uv(float(x) / float(cells), float(y) / float(cells));
            mesh.positions.emplace_back(2 * uv.x - 1, 2 * uv.y - 1,
                                        waves * std::sin(7.0f * uv.x + 3.0f * uv.y) * std::cos(5.0f * uv.y));
            mesh.normals.push_back(
                glm::normalize(glm::vec3(waves * std::sin(9 * uv.x), waves * std::cos(8 * uv.y), 1)));
            mesh.uvs.push_back(uv);
        }
    for (uint32_t y = 0; y < cells; ++y)
        for (uint32_t x = 0; x < cells; ++x) {
            const uint32_t a = y * (cells + 1) + x, b = a + 1, c = a + cells + 1, d = c + 1;
            mesh.triangles.push_back({a, b, d});
            mesh.triangles.push_back({a, d, c});
        }
    return mesh;
}

ZoneMap torture_map(uint32_t side, uint32_t zone_count, uint32_t square)
{
    ZoneMap map = {side, zone_count, {}};
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) {
            const uint64_t h = claque::base::hash(1, (y / square) * side + x / square, claque::base::Purpose::pick);
            const uint32_t mixed = static_cast<uint32_t>(h % zone_count), band = 2 * x * zone_count / side;
            map.zones.push_back(static_cast<uint16_t>(2 * x < side ? band : mixed));
        }
    return map;
}

void whiten(model::Template &tmpl)
{
    const auto whiten = [](model::Array<uint8_t> &rgba) {
        for (size_t i = 0; i < rgba.size(); i += 4) std::fill_n(&rgba[i], 3, uint8_t(255));
    };
    for (model::Texture &texture : tmpl.textures) {
        whiten(texture.rgba);
        for (model::TextureImage &other : texture.set_images) whiten(other.rgba);
    }
}

void paint(model::Template &tmpl)
{
    for (model::Texture &texture : tmpl.textures)
        for (size_t i = 0; i < texture.rgba.size(); ++i)
            if (i % 4 != 3) texture.rgba[i] = static_cast<uint8_t>(150 + claque::base::mix(i) % 106);
}

std::vector<uint8_t> zone_colours(uint32_t zone_count)
{
    std::vector<uint8_t> colours;
    for (uint32_t zone = 0; zone < zone_count; ++zone)
        colours.insert(colours.end(),
                       {static_cast<uint8_t>(60 + 24 * (zone % 8)), static_cast<uint8_t>(50 + 25 * (zone / 8 % 8)),
                        static_cast<uint8_t>(250 - 40 * (zone % 5) - 3 * (zone / 64))});
    return colours;
}

}  // namespace gltest
