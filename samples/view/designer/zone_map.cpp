#include "samples/view/designer/zone_map.h"

#include <claque/mesh.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <numeric>

#include "samples/scenes/check.h"
#include "samples/scenes/zone_inks.h"

namespace view
{
namespace
{

struct Corner {
    float u, v;
};
using Triangle = std::array<Corner, 3>;

// Those that show a texture, in texture coordinates.
std::vector<Triangle> triangles_of(const clq_template *tmpl, uint32_t texture)
{
    clq_mesh mesh = clq_mesh_init();
    scenes::check(clq_template_get_mesh(tmpl, 0, &mesh));
    std::vector<Triangle> all;
    for (uint32_t bin = 0; bin < mesh.bin_count; ++bin) {
        clq_triangles triangles = clq_triangles_init();
        scenes::check(clq_template_get_triangles(tmpl, 0, bin, &triangles));
        if (triangles.texture != texture) continue;
        for (uint32_t k = 0; k + 2 < triangles.index_count; k += 3) {
            Triangle &made = all.emplace_back();
            for (size_t c = 0; c < 3; ++c) {
                const float *uv = mesh.uvs + 2 * static_cast<size_t>(triangles.indices[k + c]);
                made[c] = {uv[0], uv[1]};
            }
        }
    }
    return all;
}

float area(const Corner &a, const Corner &b, float u, float v)
{
    return (b.u - a.u) * (v - a.v) - (b.v - a.v) * (u - a.u);
}

// Whether it holds a place, or one at most `near` outside of an edge.
bool holds(const Triangle &t, float u, float v, float near)
{
    const float whole = area(t[0], t[1], t[2].u, t[2].v), turn = whole < 0 ? -1.0f : 1.0f;
    for (size_t k = 0; k < 3; ++k) {
        const Corner &a = t[k], &b = t[(k + 1) % 3];
        if (turn * area(a, b, u, v) < -near * std::hypot(b.u - a.u, b.v - a.v)) return false;
    }
    return whole != 0;
}

// The number of the island of each triangle: those that share a corner hang together.
std::vector<size_t> islands_of(const std::vector<Triangle> &triangles)
{
    std::vector<size_t> leader(triangles.size());
    std::iota(leader.begin(), leader.end(), size_t(0));
    const auto first = [&](size_t k) {
        while (leader[k] != k) k = leader[k] = leader[leader[k]];
        return k;
    };
    std::map<std::pair<float, float>, size_t> seen;
    for (size_t k = 0; k < triangles.size(); ++k)
        for (const Corner &corner : triangles[k]) {
            const auto [found, fresh] = seen.try_emplace({corner.u, corner.v}, k);
            if (!fresh) leader[first(k)] = first(found->second);
        }
    for (size_t k = 0; k < leader.size(); ++k) leader[k] = first(k);
    return leader;
}

uint32_t wrapped(long at, uint32_t count)
{
    const long n = static_cast<long>(count);
    return static_cast<uint32_t>((at % n + n) % n);
}

void fill_triangle(ZoneMap &map, uint8_t zone, const Triangle &t)
{
    const float w = static_cast<float>(map.width()), h = static_cast<float>(map.height());
    const auto [u0, u1] = std::minmax({t[0].u, t[1].u, t[2].u});
    const auto [v0, v1] = std::minmax({t[0].v, t[1].v, t[2].v});
    // An edge takes the texels that it crosses, so that no seam is left.
    const float near = 0.75f / std::min(w, h);
    for (long y = std::lround(std::floor(v0 * h)) - 1; y <= std::lround(std::ceil(v1 * h)); ++y)
        for (long x = std::lround(std::floor(u0 * w)) - 1; x <= std::lround(std::ceil(u1 * w)); ++x)
            if (holds(t, (static_cast<float>(x) + 0.5f) / w, (static_cast<float>(y) + 0.5f) / h, near))
                map.set(wrapped(x, map.width()), wrapped(y, map.height()), zone);
}

}  // namespace

ZoneMap::ZoneMap(uint32_t width_px, uint32_t height_px)
    : width_(width_px), height_(height_px), across_((width_px + side - 1) / side)
{
    const auto empty = std::make_shared<Tile>();
    empty->fill(none);
    tiles_.assign(static_cast<size_t>(across_) * ((height_px + side - 1) / side), empty);
}

void ZoneMap::set(uint32_t x, uint32_t y, uint8_t zone)
{
    if (x >= width_ || y >= height_ || at(x, y) == zone) return;
    std::shared_ptr<Tile> &tile = tiles_[static_cast<size_t>(y / side) * across_ + x / side];
    if (tile.use_count() > 1) tile = std::make_shared<Tile>(*tile);
    (*tile)[place(x, y)] = zone;
}

uint8_t ZoneMap::zone(const std::string &name)
{
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<uint8_t>(found - names.begin());
    if (names.size() >= none) return none;
    names.push_back(name);
    return static_cast<uint8_t>(names.size() - 1);
}

bool operator==(const ZoneMap &a, const ZoneMap &b)
{
    if (a.tmpl != b.tmpl || a.texture_set != b.texture_set || a.texture != b.texture || a.names != b.names ||
        a.reduced != b.reduced || a.width_ != b.width_ || a.height_ != b.height_)
        return false;
    for (size_t k = 0; k < a.tiles_.size(); ++k)
        if (a.tiles_[k] != b.tiles_[k] && *a.tiles_[k] != *b.tiles_[k]) return false;
    return true;
}

void stroke(ZoneMap &map, uint8_t zone, const float (&from)[2], const float (&to)[2], float diameter_px)
{
    const float w = static_cast<float>(map.width()), h = static_cast<float>(map.height()), r = diameter_px / 2;
    const float x0 = from[0] * w, y0 = from[1] * h, dx = to[0] * w - x0, dy = to[1] * h - y0;
    const float squared = dx * dx + dy * dy;
    const auto whole = [](float value, uint32_t count) {
        return static_cast<uint32_t>(std::clamp(value, 0.0f, static_cast<float>(count)));
    };
    for (uint32_t y = whole(std::min(y0, y0 + dy) - r, map.height());
         y < whole(std::max(y0, y0 + dy) + r + 1, map.height()); ++y)
        for (uint32_t x = whole(std::min(x0, x0 + dx) - r, map.width());
             x < whole(std::max(x0, x0 + dx) + r + 1, map.width()); ++x) {
            const float px = static_cast<float>(x) + 0.5f - x0, py = static_cast<float>(y) + 0.5f - y0;
            const float along = squared > 0 ? std::clamp((px * dx + py * dy) / squared, 0.0f, 1.0f) : 0;
            if (std::hypot(px - along * dx, py - along * dy) <= std::max(r, 0.71f)) map.set(x, y, zone);
        }
}

bool fill_island(ZoneMap &map, uint8_t zone, const clq_template *tmpl, float u, float v)
{
    const std::vector<Triangle> triangles = triangles_of(tmpl, map.texture);
    const std::vector<size_t> islands = islands_of(triangles);
    for (size_t k = 0; k < triangles.size(); ++k) {
        if (!holds(triangles[k], u, v, 0)) continue;
        for (size_t other = 0; other < triangles.size(); ++other)
            if (islands[other] == islands[k]) fill_triangle(map, zone, triangles[other]);
        return true;
    }
    return false;
}

std::vector<uint16_t> texels_of(const ZoneMap &map)
{
    std::vector<uint16_t> texels;
    for (uint32_t y = 0; y < map.height(); ++y)
        for (uint32_t x = 0; x < map.width(); ++x)
            texels.push_back(map.at(x, y) == ZoneMap::none ? CLQ_NO_ZONE : map.at(x, y));
    return texels;
}

std::vector<uint8_t> picture_of(const ZoneMap &map, std::vector<std::string> &colours)
{
    std::vector<uint16_t> texels = texels_of(map);
    std::deque<size_t> edge;
    for (size_t k = 0; k < texels.size(); ++k)
        if (texels[k] != CLQ_NO_ZONE) edge.push_back(k);
    for (; !edge.empty(); edge.pop_front()) {
        const size_t at = edge.front(), x = at % map.width();
        const auto spread = [&](bool inside, size_t to) {
            if (!inside || texels[to] != CLQ_NO_ZONE) return;
            texels[to] = texels[at];
            edge.push_back(to);
        };
        spread(x > 0, at - 1);
        spread(x + 1 < map.width(), at + 1);
        spread(at >= map.width(), at - map.width());
        spread(at + map.width() < texels.size(), at + map.width());
    }
    colours.assign(map.names.size(), "");
    for (size_t zone = 0; zone < colours.size(); ++zone) {
        const auto covered = static_cast<size_t>(std::count(texels.begin(), texels.end(), zone));
        if (covered * min_zone_share >= texels.size()) colours[zone] = scenes::hex_of(scenes::zone_ink(zone));
    }
    std::vector<uint8_t> rgb;
    for (const uint16_t zone : texels) {
        const scenes::Ink ink = zone == CLQ_NO_ZONE ? scenes::Ink{} : scenes::zone_ink(zone);
        rgb.insert(rgb.end(), ink.begin(), ink.end());
    }
    return rgb;
}

}  // namespace view
