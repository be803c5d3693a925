// Visible parts of a surface, which the errors of levels of detail are measured on.
#include "lib/lod/surface/visibility.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/base/hash.h"
#include "lib/figures/figure.h"
#include "lib/lod/chain.h"
#include "lib/lod/surface/area_fractions.h"
#include "lib/lod/surface/occluders.h"

using namespace claque;

namespace
{

// Twelve triangles that face outwards.
void add_box(glm::dvec3 middle, double half, std::vector<lod::VisibilityQuery> &queries)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 n(0), u(0), v(0);
            n[axis] = side * half, u[(axis + 1) % 3] = half, v[(axis + 2) % 3] = side * half;
            queries.push_back({{middle + n - u - v, middle + n + u - v, middle + n + u + v}, false});
            queries.push_back({{middle + n - u - v, middle + n + u + v, middle + n - u + v}, false});
        }
}

glm::dvec3 random_point(uint64_t i)
{
    const auto random_unit = [i](uint64_t k) { return double(base::unit(base::mix(3 * i + k))); };
    return {random_unit(0), random_unit(1), random_unit(2)};
}

// Advances the light ray until it is past all triangles.
bool blocked(const std::vector<lod::Corners3> &triangles, glm::dvec3 from, glm::dvec3 dir, double after)
{
    for (const auto &t : triangles) {
        const glm::dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
        const double towards = glm::dot(n, dir);
        if (towards == 0) continue;
        const double far = glm::dot(n, t[0] - from) / towards;
        if (!(far > after)) continue;
        const glm::dvec3 p = from + far * dir;
        bool inside = true;
        for (size_t k = 0; k < 3; ++k) inside = inside && glm::dot(glm::cross(t[(k + 1) % 3] - t[k], p - t[k]), n) >= 0;
        if (inside) return true;
    }
    return false;
}

}  // namespace

TEST(Occluders, AgreeWithATestOfEveryTriangle)
{
    std::vector<lod::Corners3> triangles;
    for (uint64_t i = 0; i < 60; ++i) {
        const glm::dvec3 p = 4.0 * random_point(i);
        triangles.push_back({p, p + random_point(1000 + i), p + random_point(2000 + i)});
    }
    const lod::Occluders occluders(triangles);
    size_t met = 0;
    for (uint64_t i = 0; i < 40; ++i) {
        lod::Occluders::Ray ray(glm::normalize(random_point(4000 + i) - glm::dvec3(0.5)));
        for (uint64_t k = 0; k < 10; ++k) {  // the occluder of one ray need not occlude the next
            const glm::dvec3 from = 4.0 * random_point(3000 + 10 * i + k);
            const double after = k % 3 == 0 ? 1.5 : 0;
            const bool intersects = occluders.intersects(from, ray, after);
            EXPECT_EQ(intersects, blocked(triangles, from, ray.dir, after)) << i;
            met += intersects;
        }
    }
    EXPECT_GT(met, 40u);
    EXPECT_LT(met, 360u);
}

TEST(Visibility, IsZeroForABoxInsideABoxAndNotForOneBesideIt)
{
    std::vector<lod::VisibilityQuery> queries;
    add_box({0, 0, 0}, 2, queries);
    add_box({0, 0, 0}, 1, queries);
    add_box({9, 0, 0}, 1, queries);
    const std::vector<double> visibility = lod::visibility_of(queries);
    ASSERT_EQ(visibility.size(), 36u);
    for (size_t t = 0; t < 36; ++t)
        if (t >= 12 && t < 24) {
            EXPECT_EQ(visibility[t], 0);
        } else {
            EXPECT_GT(visibility[t], 0.25);
            EXPECT_LE(visibility[t], 0.5);
        }
}

TEST(Visibility, OfWhatLiesBehindHolesIsThatOfOpenSurface)
{
    std::vector<lod::VisibilityQuery> alone, behind;
    add_box({0, 0, 0}, 1, alone), add_box({0, 0, 0}, 1, behind);
    add_box({0, 0, 0}, 2, behind);
    for (size_t t = 12; t < 24; ++t) behind[t].has_holes = true;
    const std::vector<double> open = lod::visibility_of(alone), seen = lod::visibility_of(behind);
    for (size_t t = 0; t < 12; ++t) EXPECT_EQ(seen[t], open[t]) << t;
    for (size_t t = 12; t < 24; ++t) EXPECT_GT(seen[t], 0.25) << t;
}

TEST(Visibility, IncludesTheBackOfADoubleSidedSheetOnly)
{
    lod::VisibilityQuery sheet{{glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}, false};
    const double one = lod::visibility_of({sheet})[0];
    sheet.two_sided = true;
    EXPECT_NEAR(lod::visibility_of({sheet})[0], one + 5.0 / 14 + 4.0 / 14, 1e-9) << "edge on from four sides";
}

TEST(Decimate, KeepsAreaFractionsOfZonesBetterWhereTheyAreGiven)
{
    const model::Model person = figures::plebeian_man();
    std::vector<const model::Part *> parts;
    std::vector<lod::SourcePart> pieces;
    for (const model::Part &part : person.parts) parts.push_back(&part), pieces.push_back({&part});
    const auto zone_area = [&](const model::Model *model) {
        lod::DecimationOptions decimation;
        decimation.targets = {490}, decimation.model = model;
        const std::vector<lod::Decimated> made = lod::decimate(pieces, decimation);
        std::vector<const model::Part *> left;
        for (const model::Part &part : made[0].parts) left.push_back(&part);
        return lod::zone_area_error(lod::zone_area_fractions(person, parts), lod::zone_area_fractions(person, left));
    };
    EXPECT_LT(zone_area(&person), 0.8 * zone_area(nullptr));
}
