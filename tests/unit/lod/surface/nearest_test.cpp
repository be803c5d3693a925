// Nearest points on a set of triangles.
#include "lib/lod/surface/nearest.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/base/hash.h"
#include "lib/lod/surface/point_tree.h"

using namespace claque;

namespace
{

double random_unit(uint64_t i) { return double(base::unit(base::mix(i))); }

glm::dvec3 somewhere(uint64_t i) { return {random_unit(3 * i), random_unit(3 * i + 1), random_unit(3 * i + 2)}; }

// Triangles, needles and points among each other; many share corners, so that several are equally near.
std::vector<lod::NearestPoint::Triangle> triangles_in_a_box(glm::dvec3 at, double size)
{
    std::vector<glm::dvec3> corners;
    for (uint64_t i = 0; i < 60; ++i) corners.push_back(at + size * somewhere(7000 + i));
    std::vector<lod::NearestPoint::Triangle> triangles;
    for (uint64_t i = 0; i < 300; ++i) {
        const glm::dvec3 a = corners[i % 60], b = corners[i * 7 % 60], c = corners[i * 11 % 60];
        const glm::dvec3 beside = b + 1e-7 * (c - b);
        triangles.push_back({a, b, i % 5 == 0 ? beside : i % 7 == 0 ? b : c});
    }
    return triangles;
}

}  // namespace

TEST(NearestPoint, IsAsNearAsTheBestOfAllTriangles)
{
    std::vector<lod::NearestPoint::Triangle> triangles;
    for (uint64_t i = 0; i < 300; ++i) {
        const glm::dvec3 at = 4.0 * somewhere(1000 + i);
        triangles.push_back({at, at + somewhere(2000 + i), at + somewhere(3000 + i)});
    }
    triangles.push_back({glm::dvec3(9), glm::dvec3(9), glm::dvec3(9)});  // no area
    const lod::NearestPoint nearest(triangles);
    for (uint64_t i = 0; i < 500; ++i) {
        const glm::dvec3 p = 6.0 * somewhere(5000 + i) - glm::dvec3(1);
        double best = 1e30;
        for (const auto &t : triangles) {
            const glm::dvec3 off = lod::point_on(t, lod::nearest_on(t, p)) - p;
            best = std::min(best, glm::dot(off, off));
        }
        EXPECT_EQ(nearest.to(p).distance_squared, best);
    }
}

// Compared with a search over a fine grid of points on the triangle.
TEST(NearestPoint, OfOneTriangleIsNearerThanAnyPointOfAGrid)
{
    for (uint64_t i = 0; i < 50; ++i) {
        const lod::NearestPoint::Triangle t = {somewhere(i), somewhere(100 + i), somewhere(200 + i)};
        const glm::dvec3 p = 2.0 * somewhere(300 + i);
        const double found = glm::length(lod::point_on(t, lod::nearest_on(t, p)) - p);
        double net = 1e30;
        for (int a = 0; a <= 60; ++a)
            for (int b = 0; a + b <= 60; ++b)
                net = std::min(net, glm::length(lod::point_on(t, glm::dvec3(a, b, 60 - a - b) / 60.0) - p));
        EXPECT_LE(found, net + 1e-12);
        EXPECT_GE(found, net - 0.05);
    }
}

// With needles, lines and points, small and far from the origin, and from points on them, near by and far away.
TEST(NearestPoint, IsTheSameTriangleWhateverTheGuess)
{
    for (const double size : {1e-3, 1.0, 1e6})
        for (const double away : {0.0, 10.0}) {
            const auto triangles = triangles_in_a_box(size * glm::dvec3(away), size);
            const lod::NearestPoint nearest(triangles);
            for (uint64_t i = 0; i < 300; ++i) {
                const double far = i % 10 == 0 ? 1000 : 1.5;
                const glm::dvec3 on = lod::point_on(triangles[i], {0.25, 0.25, 0.5});
                const glm::dvec3 p = i % 3 ? size * (glm::dvec3(away - 0.25) + far * somewhere(9000 + i)) : on;
                double best = 1e300;
                for (const auto &t : triangles) {
                    const glm::dvec3 off = lod::point_on(t, lod::nearest_on(t, p)) - p;
                    best = std::min(best, glm::dot(off, off));
                }
                const lod::NearestPoint::Found found = nearest.to(p);
                ASSERT_EQ(found.distance_squared, best) << i << " of size " << size;
                for (const uint32_t guess : {0u, 17u, 299u}) {
                    ASSERT_EQ(nearest.to(p, guess).triangle, found.triangle) << i << " of size " << size;
                    ASSERT_EQ(nearest.to(p, guess).distance_squared, best);
                }
            }
        }
}

// Floats cannot tell distances of 1e30 times the size apart, or hold their squares.
TEST(NearestPoint, IsFoundFromTooFarAwayForFloats)
{
    const auto triangles = triangles_in_a_box(glm::dvec3(0), 1);
    const lod::NearestPoint nearest(triangles);
    EXPECT_LT(nearest.to(glm::dvec3(1e30, 0, 0)).triangle, triangles.size());
    EXPECT_NEAR(nearest.to(glm::dvec3(1e30, 0, 0)).distance_squared / 1e60, 1, 1e-9);
}

// With needles, lines and points among them, from near by and far away.
TEST(FewTriangles, FindTheFirstOfTheNearest)
{
    for (const size_t count : {1u, 4u, 5u, 23u}) {
        auto triangles = triangles_in_a_box(glm::dvec3(0), 1);
        triangles.resize(count);
        const lod::FewTriangles few(triangles);
        for (uint64_t i = 0; i < 300; ++i) {
            const double far = i % 10 == 0 ? 1e30 : i % 10 == 1 ? 1000 : 1.5;
            const glm::dvec3 on = lod::point_on(triangles[i % count], {0.25, 0.25, 0.5});
            const glm::dvec3 p = i % 3 ? far * somewhere(9000 + i) - glm::dvec3(0.25) : on;
            uint32_t first = 0;
            double best = HUGE_VAL;
            for (uint32_t t = 0; t < count; ++t) {
                const glm::dvec3 off = lod::point_on(triangles[t], lod::nearest_on(triangles[t], p)) - p;
                if (glm::dot(off, off) < best) best = glm::dot(off, off), first = t;
            }
            const lod::NearestPoint::Found found = few.to(p);
            ASSERT_EQ(found.distance_squared, best) << i << " among " << count;
            ASSERT_EQ(found.triangle, first) << i << " among " << count;
            ASSERT_EQ(found.weights, lod::nearest_on(triangles[first], p));
        }
    }
    EXPECT_EQ(lod::FewTriangles({}).to(glm::dvec3(0)).distance_squared, HUGE_VAL);
}

// As a search over triangles without area finds it, also where several points are equally near.
TEST(PointTree, FindsTheSamePointAsATreeOfTriangles)
{
    for (const size_t count : {1u, 2u, 5u, 400u}) {
        std::vector<glm::dvec3> points;
        std::vector<lod::NearestPoint::Triangle> triangles;
        for (uint64_t i = 0; i < count; ++i) {
            const glm::dvec3 p = 8.0 * somewhere(i);
            points.push_back(i % 2 ? p : glm::floor(p));
            triangles.push_back({points[i], points[i], points[i]});
        }
        const lod::PointTree tree(points);
        const lod::NearestPoint other(triangles);
        for (uint64_t i = 0; i < 600; ++i) {
            const glm::dvec3 p = 12.0 * somewhere(9000 + i) - glm::dvec3(2), at = i % 3 ? p : glm::floor(p);
            const lod::PointTree::Found found = tree.to(at);
            EXPECT_EQ(found.point, other.to(at).triangle);
            double least = HUGE_VAL;
            for (const glm::dvec3 one : points) least = std::min(least, glm::dot(one - at, one - at));
            EXPECT_EQ(found.distance_squared, least);
        }
    }
}
