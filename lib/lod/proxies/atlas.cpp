#include "lib/lod/proxies/atlas.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace claque::lod
{

namespace
{

// Minimum cosine between a triangle's normal and its chart's normal: flattening halves lengths at most.
constexpr double min_cosine = 0.5;

using Flat = std::array<glm::dvec2, 3>;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

glm::dvec3 unit_or(glm::dvec3 v, glm::dvec3 other)
{
    const double length = glm::length(v);
    return length > 0 ? v / length : other;
}

// Returns whether two triangles of the same orientation share no interior point. By the separating axis test, some side
// of one then has all of the other outside it.
bool disjoint(const Flat &a, const Flat &b)
{
    for (const auto &[one, other] : {std::make_pair(&a, &b), std::make_pair(&b, &a)})
        for (size_t k = 0; k < 3; ++k) {
            const glm::dvec2 from = (*one)[k], along = (*one)[(k + 1) % 3] - from;
            const double slack = 1e-9 * glm::dot(along, along);
            if (std::all_of(other->begin(), other->end(),
                            [&](glm::dvec2 p) { return cross(along, p - from) <= slack; }))
                return true;
        }
    return false;
}

// Grows charts from the largest triangle, across edges to the neighbours whose normals are closest.
class ChartGrowth
{
public:
    explicit ChartGrowth(const PosedParts &level)
        : level_(level), beside_(neighbours_of(level)), chart_(level.triangles().size(), model::none)
    {
        for (const PosedParts::Triangle &t : level.triangles()) {
            const auto c = level.corners(t);
            normals_.push_back(unit_or(glm::cross(c[1] - c[0], c[2] - c[0]), glm::dvec3(0)));
        }
    }

    void run(std::vector<std::vector<uint32_t>> &charts, std::vector<Flat> &texel_coords)
    {
        std::vector<uint32_t> order(chart_.size());
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(),
                         [&](uint32_t a, uint32_t b) { return area_of(level_, a) > area_of(level_, b); });
        texel_coords.resize(chart_.size());
        for (const uint32_t seed : order)
            if (chart_[seed] == model::none) {
                charts.emplace_back();
                grow(seed, static_cast<uint32_t>(charts.size() - 1), charts.back(), texel_coords);
            }
    }

private:
    void grow(uint32_t seed, uint32_t chart, std::vector<uint32_t> &members, std::vector<Flat> &texel_coords)
    {
        const glm::dvec3 normal = unit_or(normals_[seed], glm::dvec3(0, 0, 1));
        const glm::dvec3 helper = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 u = glm::normalize(glm::cross(normal, helper)), v = glm::cross(normal, u);
        const auto flat = [&](uint32_t t) {
            const auto c = level_.corners(level_.triangles()[t]);
            return Flat{glm::dvec2(glm::dot(c[0], u), glm::dot(c[0], v)),
                        glm::dvec2(glm::dot(c[1], u), glm::dot(c[1], v)),
                        glm::dvec2(glm::dot(c[2], u), glm::dot(c[2], v))};
        };
        std::set<std::pair<double, uint32_t>> open = {{-1.0, seed}};
        while (!open.empty()) {
            const uint32_t t = open.begin()->second;
            open.erase(open.begin());
            if (chart_[t] != model::none) continue;
            const Flat projected = flat(t);
            if (!std::all_of(members.begin(), members.end(),
                             [&](uint32_t m) { return disjoint(projected, texel_coords[m]); }))
                continue;
            chart_[t] = chart;
            members.push_back(t);
            texel_coords[t] = projected;
            for (const uint32_t next : beside_[t]) {
                const double cosine = glm::dot(normals_[next], normal);
                if (chart_[next] == model::none && cosine >= min_cosine) open.insert({-cosine, next});
            }
        }
    }

    const PosedParts &level_;
    std::vector<glm::dvec3> normals_;
    std::vector<std::vector<uint32_t>> beside_;
    std::vector<uint32_t> chart_;
};

struct Box {
    glm::dvec2 first = glm::dvec2(0), size = glm::dvec2(0);
};

Box box_of(const std::vector<uint32_t> &chart, const std::vector<Flat> &texel_coords, glm::dvec2 along)
{
    glm::dvec2 first(std::numeric_limits<double>::infinity()), last = -first;
    for (const uint32_t t : chart)
        for (const glm::dvec2 p : texel_coords[t]) {
            const glm::dvec2 q(glm::dot(p, along), cross(along, p));
            first = glm::min(first, q), last = glm::max(last, q);
        }
    return {first, last - first};
}

// Rotates the chart to its smallest bounding box, aligned with one of its triangle sides, longer side along x, and
// moves it to the origin. Returns the size of the box.
glm::dvec2 rotate_to_smallest_box(const std::vector<uint32_t> &chart, std::vector<Flat> &texel_coords)
{
    glm::dvec2 best(1, 0);
    double least = std::numeric_limits<double>::infinity();
    for (const uint32_t t : chart)
        for (size_t k = 0; k < 3; ++k) {
            const glm::dvec2 side = texel_coords[t][(k + 1) % 3] - texel_coords[t][k];
            const double length = glm::length(side);
            if (!(length > 0)) continue;
            const glm::dvec2 size = box_of(chart, texel_coords, side / length).size;
            if (size.x * size.y < least)
                least = size.x * size.y, best = size.x < size.y ? glm::dvec2(-side.y, side.x) / length : side / length;
        }
    const Box box = box_of(chart, texel_coords, best);
    for (const uint32_t t : chart)
        for (glm::dvec2 &p : texel_coords[t]) p = glm::dvec2(glm::dot(p, best), cross(best, p)) - box.first;
    return box.size;
}

// Packs charts on shelves, the tallest chart first. Returns false if they do not fit.
bool pack(const std::vector<glm::dvec2> &sizes, const std::vector<uint32_t> &order, Atlas &atlas)
{
    uint32_t x = 0, y = 0, tall = 0;
    for (const uint32_t i : order) {
        Chart &chart = atlas.charts[i];
        const glm::dvec2 texels = glm::ceil(sizes[i] / atlas.texel_size);
        if (texels.x > atlas.width || texels.y > atlas.height) return false;
        chart.width = static_cast<uint32_t>(texels.x) + 2 * atlas_gutter;
        chart.height = static_cast<uint32_t>(texels.y) + 2 * atlas_gutter;
        if (x + chart.width > atlas.width) y += tall, x = 0, tall = 0;
        if (x + chart.width > atlas.width || y + chart.height > atlas.height) return false;
        chart.x = x, chart.y = y;
        x += chart.width, tall = std::max(tall, chart.height);
    }
    return true;
}

}  // namespace

Atlas build_atlas(const PosedParts &level, uint32_t texels)
{
    Atlas atlas;
    std::vector<std::vector<uint32_t>> charts;
    ChartGrowth(level).run(charts, atlas.texel_coords);
    std::vector<glm::dvec2> sizes;
    std::vector<uint32_t> order(charts.size());
    std::iota(order.begin(), order.end(), 0u);
    for (std::vector<uint32_t> &chart : charts) {
        sizes.push_back(rotate_to_smallest_box(chart, atlas.texel_coords));
        atlas.charts.emplace_back();
        atlas.charts.back().triangles = std::move(chart);
    }
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return sizes[a].y > sizes[b].y; });
    double area = 0;
    for (uint32_t t = 0; t < level.triangles().size(); ++t) area += area_of(level, t);
    const size_t wanted = size_t(texels) * level.triangles().size();
    for (uint32_t bits = 0;; ++bits) {
        atlas.width = 1u << (bits + 1) / 2, atlas.height = 1u << bits / 2;
        if (size_t(atlas.width) * atlas.height < wanted) continue;
        atlas.texel_size = std::sqrt(area / (double(atlas.width) * atlas.height));
        if (!(atlas.texel_size > 0)) atlas.texel_size = 1;
        bool packed = false;
        // The search stops at half of the resolution that the area allows without gutters and gaps.
        for (int step = 0; step < 100 && !packed; ++step, atlas.texel_size *= packed ? 1 : 1.02)
            packed = pack(sizes, order, atlas);
        if (packed) break;
    }
    for (const Chart &chart : atlas.charts)
        for (const uint32_t t : chart.triangles)
            for (glm::dvec2 &p : atlas.texel_coords[t])
                p = p / atlas.texel_size + glm::dvec2(chart.x + atlas_gutter, chart.y + atlas_gutter);
    return atlas;
}

}  // namespace claque::lod
