// What of a surface can be seen, which is what levels of detail answer for.
#include "lib/lod/seen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "lib/base/hash.h"
#include "lib/figures/figure.h"
#include "lib/lod/chain.h"
#include "lib/lod/obstacles.h"
#include "lib/lod/shares.h"

using namespace claque;

namespace
{

// Twelve triangles, seen from outside.
void add_box(glm::dvec3 middle, double half, std::vector<lod::Side> &sides)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 n(0), u(0), v(0);
            n[axis] = side * half, u[(axis + 1) % 3] = half, v[(axis + 2) % 3] = side * half;
            sides.push_back({{middle + n - u - v, middle + n + u - v, middle + n + u + v}, false});
            sides.push_back({{middle + n - u - v, middle + n + u + v, middle + n - u + v}, false});
        }
}

glm::dvec3 random_point(uint64_t i)
{
    const auto lot = [i](uint64_t k) { return double(base::unit(base::mix(3 * i + k))); };
    return {lot(0), lot(1), lot(2)};
}

// Moves the light along until it is past everything.
bool blocked(const std::vector<lod::Corners3> &triangles, glm::dvec3 from, glm::dvec3 along, double after)
{
    for (const auto &t : triangles) {
        const glm::dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
        const double towards = glm::dot(n, along);
        if (towards == 0) continue;
        const double far = glm::dot(n, t[0] - from) / towards;
        if (!(far > after)) continue;
        const glm::dvec3 p = from + far * along;
        bool inside = true;
        for (size_t k = 0; k < 3; ++k) inside = inside && glm::dot(glm::cross(t[(k + 1) % 3] - t[k], p - t[k]), n) >= 0;
        if (inside) return true;
    }
    return false;
}

}  // namespace

TEST(Obstacles, say_what_is_in_the_way_as_a_look_at_every_triangle_does)
{
    std::vector<lod::Corners3> triangles;
    for (uint64_t i = 0; i < 60; ++i) {
        const glm::dvec3 p = 4.0 * random_point(i);
        triangles.push_back({p, p + random_point(1000 + i), p + random_point(2000 + i)});
    }
    const lod::Obstacles obstacles(triangles);
    size_t met = 0;
    for (uint64_t i = 0; i < 40; ++i) {
        lod::Obstacles::Way way(glm::normalize(random_point(4000 + i) - glm::dvec3(0.5)));
        for (uint64_t k = 0; k < 10; ++k) {  // what was in the way of one need not be in that of the next
            const glm::dvec3 from = 4.0 * random_point(3000 + 10 * i + k);
            const double after = k % 3 == 0 ? 1.5 : 0;
            const bool meets = obstacles.meets(from, way, after);
            EXPECT_EQ(meets, blocked(triangles, from, way.along, after)) << i;
            met += meets;
        }
    }
    EXPECT_GT(met, 40u);
    EXPECT_LT(met, 360u);
}

TEST(Seen, is_nothing_of_a_box_in_a_box_and_all_sides_of_one_beside_it)
{
    std::vector<lod::Side> sides;
    add_box({0, 0, 0}, 2, sides);
    add_box({0, 0, 0}, 1, sides);
    add_box({9, 0, 0}, 1, sides);
    const std::vector<double> seen = lod::seen_of(sides);
    ASSERT_EQ(seen.size(), 36u);
    for (size_t t = 0; t < 36; ++t)
        if (t >= 12 && t < 24) {
            EXPECT_EQ(seen[t], 0);
        } else {
            EXPECT_GT(seen[t], 0.25);
            EXPECT_LE(seen[t], 0.5);
        }
}

TEST(Seen, is_the_back_of_a_sheet_only_where_it_has_two_sides)
{
    lod::Side sheet{{glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}, false};
    const double one = lod::seen_of({sheet})[0];
    sheet.both = true;
    EXPECT_NEAR(lod::seen_of({sheet})[0], one + 5.0 / 14 + 4.0 / 14, 1e-9) << "edge on from four sides";
}

TEST(Decimate, keeps_shares_of_zones_better_where_it_is_told_what_they_are)
{
    const model::Model person = figures::plebeian_man();
    std::vector<const model::Part *> parts;
    std::vector<lod::Piece> pieces;
    for (const model::Part &part : person.parts) parts.push_back(&part), pieces.push_back({&part});
    const auto drift = [&](const model::Model *model) {
        lod::Decimation how;
        how.targets = {490}, how.model = model;
        const std::vector<lod::Decimated> made = lod::decimate(pieces, how);
        std::vector<const model::Part *> left;
        for (const model::Part &part : made[0].parts) left.push_back(&part);
        return lod::largest_drift(lod::zone_shares(person, parts), lod::zone_shares(person, left));
    };
    EXPECT_LT(drift(&person), 0.8 * drift(nullptr));
}
