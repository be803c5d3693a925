// Reads areas, and holds what every area keeps.
#pragma once

#include <cmath>

#include "../trajectories/fixture.h"
#include "lib/asset/areas/area.h"

namespace claque::testing
{

inline asset::Area read_area_text(const std::string &text)
{
    return asset::read_area(reinterpret_cast<const uint8_t *>(text.data()), text.size());
}

inline Refusal area_refusal(const std::string &text)
{
    try {
        read_area_text(text);
        return {};
    } catch (const base::Error &error) {
        return {error.status(), error.what()};
    }
}

inline double side_of(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

inline double triangles_area(const asset::Area &area)
{
    double sum = 0;
    for (size_t t = 0; t < area.triangles.size(); t += 3)
        sum += side_of(&area.points[3 * size_t(area.triangles[t])], &area.points[3 * size_t(area.triangles[t + 1])],
                       &area.points[3 * size_t(area.triangles[t + 2])]) /
               2;
    return sum;
}

// In an odd number of rings.
inline bool in_rings(const asset::Area &area, double x, double y)
{
    bool inside = false;
    for (const clq_area_ring &ring : area.rings)
        for (uint32_t i = 0; i < ring.point_count; ++i) {
            const double *a = &area.points[3 * size_t(ring.first_point + i)];
            const double *b = &area.points[3 * size_t(ring.first_point + (i + 1) % ring.point_count)];
            if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) * (b[0] - a[0]) / (b[1] - a[1])) inside = !inside;
        }
    return inside;
}

inline size_t triangles_at(const asset::Area &area, double x, double y)
{
    const double at[] = {x, y};
    size_t count = 0;
    for (size_t t = 0; t < area.triangles.size(); t += 3) {
        const double *a = &area.points[3 * size_t(area.triangles[t])],
                     *b = &area.points[3 * size_t(area.triangles[t + 1])],
                     *c = &area.points[3 * size_t(area.triangles[t + 2])];
        count += side_of(a, b, at) > 0 && side_of(b, c, at) > 0 && side_of(c, a, at) > 0;
    }
    return count;
}

// Triangles are counter-clockwise and lie in the rings, each place in one, and only there.
inline void expect_filled(const asset::Area &area)
{
    EXPECT_NEAR(triangles_area(area), area.area_m2, 1e-9 * (1 + area.area_m2));
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (size_t i = 0; i < area.points.size(); ++i)
        if (i % 3 < 2)
            low[i % 3] = std::min(low[i % 3], area.points[i]), high[i % 3] = std::max(high[i % 3], area.points[i]);
    for (size_t t = 0; t < area.triangles.size(); t += 3)
        EXPECT_GE(side_of(&area.points[3 * size_t(area.triangles[t])], &area.points[3 * size_t(area.triangles[t + 1])],
                          &area.points[3 * size_t(area.triangles[t + 2])]),
                  0);
    for (int i = 0; i < 1000; ++i) {
        // A grid that turns, so that no place lies on an edge.
        const double u = std::fmod(0.1230917 + i * 0.7548776662466927, 1),
                     v = std::fmod(0.3771283 + i * 0.5698402909980532, 1);
        const double x = low[0] + u * (high[0] - low[0]), y = low[1] + v * (high[1] - low[1]);
        EXPECT_EQ(triangles_at(area, x, y), in_rings(area, x, y) ? 1u : 0u) << x << ", " << y;
    }
}

}  // namespace claque::testing
