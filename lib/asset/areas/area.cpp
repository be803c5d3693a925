#include "lib/asset/areas/area.h"

#include <algorithm>
#include <cmath>

#include "lib/asset/areas/ring_check.h"
#include "lib/asset/areas/triangulate.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;
using base::text_of;

namespace
{

bool same_point(const Point &a, const Point &b) { return a.x == b.x && a.y == b.y; }

// Without repeated points and the first one at the end. Empty: it encloses nothing.
Ring cleaned(const Ring &ring)
{
    Ring out;
    for (const Point &point : ring)
        if (out.empty() || !same_point(out.back(), point)) out.push_back(point);
    while (out.size() > 1 && same_point(out.front(), out.back())) out.pop_back();
    return out.size() < 3 || signed_area(out) == 0 ? Ring() : out;
}

double area_of(const std::vector<Ring> &rings)
{
    double sum = 0;
    for (const Ring &ring : rings) sum += signed_area(ring);  // holes run clockwise
    return sum;
}

}  // namespace

void AreaBuilder::add_polygon(const std::vector<Ring> &rings, const Plane &plane, bool walled)
{
    size_t points = 0;
    for (const Ring &ring : rings) points += ring.size();
    if (points > most_points + rings.size())
        fail(CLQ_LIMIT, "polygon %u has more than %zu points", area_.polygons + 1, most_points);
    std::vector<Ring> good;
    for (size_t i = 0; i < rings.size(); ++i) {
        good.push_back(cleaned(rings[i]));
        if (!good.back().empty()) continue;
        good.pop_back();
        warn(text_of("ring %zu of polygon %u encloses nothing: left out", i + 1, area_.polygons + 1));
        if (i == 0) return;
    }
    if (good.empty()) return;
    for (Ring &ring : good)
        if ((signed_area(ring) > 0) != (&ring == &good[0])) std::reverse(ring.begin(), ring.end());
    const std::string fault = fault_of(good);
    if (!fault.empty()) fail(CLQ_FORMAT, "polygon %u %s", area_.polygons + 1, fault.c_str());
    const uint32_t first = static_cast<uint32_t>(area_.points.size() / 3);
    for (const Ring &ring : good) keep_ring(ring, &ring != &good[0], plane, walled);
    if (!triangulate(good, first, area_.triangles))
        fail(CLQ_FORMAT, "polygon %u cannot be filled: its edges touch in too many places", area_.polygons + 1);
    area_.area_m2 += area_of(good);
    ++area_.polygons;
}

void AreaBuilder::keep_ring(const Ring &ring, bool hole, const Plane &plane, bool walled)
{
    clq_area_ring kept{};
    kept.polygon = area_.polygons;
    kept.first_point = static_cast<uint32_t>(area_.points.size() / 3);
    kept.point_count = static_cast<uint32_t>(ring.size());
    kept.hole = hole;
    for (const Point &point : ring) add_point(point, plane);
    for (uint32_t i = 0; i < kept.point_count && walled; ++i)
        add_wall(kept.first_point + i, kept.first_point + (i + 1) % kept.point_count);
    area_.rings.push_back(kept);
}

void AreaBuilder::add_wall(uint32_t from, uint32_t to)
{
    area_.walls.push_back(from);
    area_.walls.push_back(to);
}

uint32_t AreaBuilder::add_point(const Point &at, const Plane &plane)
{
    area_.points.insert(area_.points.end(), {at.x, at.y, plane.height(at)});
    return static_cast<uint32_t>(area_.points.size() / 3 - 1);
}

}  // namespace claque::asset
