// Coarse closed surfaces: fitting them to fine ones, and reducing them by the visible error.
#include "lib/lod/proxies/reduce.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/lod/proxies/fit.h"
#include "lib/lod/proxies/vertex_merge.h"
#include "tests/unit/lod/proxies/closed.h"

using namespace claque;

namespace
{

using Corners = lod::Voxels::Triangle;

void add_box(glm::dvec3 low, glm::dvec3 high, std::vector<Corners> &out)
{
    const auto corner = [&](int k) {
        return glm::dvec3(k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z);
    };
    for (const auto &s :
         {std::array{0, 2, 6, 4}, {1, 5, 7, 3}, {2, 3, 7, 6}, {0, 4, 5, 1}, {0, 1, 3, 2}, {4, 6, 7, 5}}) {
        out.push_back({corner(s[0]), corner(s[1]), corner(s[2])});
        out.push_back({corner(s[0]), corner(s[2]), corner(s[3])});
    }
}

// A trunk on two legs; one arm hangs, the other hand is on the hip, which makes a hole.
lod::ClosedMesh figure()
{
    std::vector<Corners> boxes;
    add_box({-0.2, 0.8, -0.1}, {0.2, 1.5, 0.1}, boxes);
    add_box({-0.09, 1.5, -0.09}, {0.09, 1.8, 0.09}, boxes);
    for (const double side : {-0.2, 0.06}) add_box({side, 0, -0.07}, {side + 0.14, 0.8, 0.07}, boxes);
    add_box({-0.42, 1.4, -0.05}, {-0.2, 1.5, 0.05}, boxes);
    add_box({-0.42, 0.7, -0.05}, {-0.32, 1.5, 0.05}, boxes);
    add_box({0.2, 1.4, -0.05}, {0.5, 1.5, 0.05}, boxes);
    add_box({0.4, 0.9, -0.05}, {0.5, 1.5, 0.05}, boxes);
    add_box({0.2, 0.9, -0.05}, {0.5, 1.0, 0.05}, boxes);
    lod::Voxels voxels(boxes, 40);
    voxels.fill();
    return lod::extract_closed_mesh(voxels);
}

// From points all over `from` to the nearest point of `to`.
double mean_square(const lod::ClosedMesh &from, const lod::ClosedMesh &to)
{
    const lod::NearestPoint nearest(lod::corners_of(to));
    double sum = 0, area = 0;
    for (const auto &t : lod::corners_of(from))
        for (int i = 0; i < 4; ++i)
            for (int j = 0; i + j < 4; ++j) {
                const double b = (i + 0.3) / 4, c = (j + 0.3) / 4, a = glm::length(lod::twice_area(t));
                sum += a * nearest.to(lod::point_on(t, {1 - b - c, b, c})).distance_squared, area += a;
            }
    return sum / area;
}

class Figure : public testing::Test
{
protected:
    const lod::ClosedMesh fine = figure();
    const std::vector<lod::Attributes> nothing = std::vector<lod::Attributes>(fine.positions.size());
    const lod::FineSurface surface{fine, nothing, 2000};
};

using Fit = Figure;
using Reduce = Figure;

}  // namespace

TEST_F(Fit, BringsBothSurfacesNearerToEachOther)
{
    for (lod::CoarseMesh &coarse : lod::coarsen(fine, nothing, {250, 120, 60})) {
        const size_t triangles = coarse.surface.triangles.size();
        const double there = mean_square(fine, coarse.surface), back = mean_square(coarse.surface, fine);
        lod::fit(surface, coarse);
        EXPECT_LT(mean_square(fine, coarse.surface) + mean_square(coarse.surface, fine), 0.9 * (there + back));
        EXPECT_EQ(coarse.surface.triangles.size(), triangles);
    }
}

TEST(FitOfItself, LeavesASurfaceWhereItIs)
{
    std::vector<Corners> box;
    add_box({0, 0, 0}, {1, 2, 1}, box);
    lod::Voxels voxels(box, 10);
    voxels.fill();
    lod::CoarseMesh same;
    same.surface = lod::extract_closed_mesh(voxels);
    const lod::ClosedMesh fine = same.surface;
    const std::vector<lod::Attributes> nothing(fine.positions.size());
    same.features.resize(fine.positions.size());
    lod::fit({fine, nothing, fine.positions.size()}, same);
    for (size_t v = 0; v < fine.positions.size(); ++v)
        EXPECT_LT(glm::length(same.surface.positions[v] - fine.positions[v]), 1e-6);
}

TEST_F(Fit, FitsVerticesToTheirNearestPoints)
{
    std::vector<lod::Attributes> halves;
    for (const glm::dvec3 p : fine.positions) halves.push_back({{p.y < 0.8 ? 1u : 2u, 1.0}});
    lod::CoarseMesh coarse = lod::coarsen(fine, halves, {120})[0];
    lod::fit({fine, halves, 2000}, coarse);
    for (size_t v = 0; v < coarse.features.size(); ++v) {
        const glm::dvec3 p = coarse.surface.positions[v];
        double below = 0, all = 0;
        for (const lod::Attribute &one : coarse.features[v].mean)
            below += one.id == 1 ? one.value : 0, all += one.value;
        EXPECT_NEAR(all, 1, 1e-9);
        if (p.y < 0.2) {
            EXPECT_GT(below, 0.8);  // triangles of a leg reach up to the hip
        }
        if (p.y > 1.6) {
            EXPECT_EQ(below, 0);
        }
    }
}

TEST_F(Reduce, ClosesHolesAndKeepsLimbsOn)
{
    const lod::CoarseMesh from = lod::coarsen(fine, nothing, {180})[0];
    const std::vector<size_t> targets = {120, 60, 30, 20};
    const std::vector<lod::CoarseMesh> levels = lod::reduce_by_distance(surface, from, targets);
    ASSERT_EQ(levels.size(), targets.size());
    for (size_t k = 0; k < levels.size(); ++k) {
        EXPECT_LE(levels[k].surface.triangles.size(), targets[k]);
        EXPECT_GE(levels[k].surface.triangles.size(), targets[k] * 4 / 5);
        EXPECT_TRUE(test::is_closed(levels[k].surface));
        EXPECT_EQ(lod::component_count(levels[k].surface.triangles), 1u);
    }
}

// Planes are unbounded: losing a thin feature costs their quadric little.
TEST_F(Reduce, IsNearerThanPlanesAre)
{
    const std::vector<size_t> targets = {60, 30, 20};
    const std::vector<lod::CoarseMesh> by_planes = lod::coarsen(fine, nothing, targets);
    const std::vector<lod::CoarseMesh> levels =
        lod::reduce_by_distance(surface, lod::coarsen(fine, nothing, {120})[0], targets);
    for (size_t k = 0; k < targets.size(); ++k)
        EXPECT_LT(mean_square(fine, levels[k].surface), 0.5 * mean_square(fine, by_planes[k].surface)) << targets[k];
}

TEST_F(Reduce, GivesALevelWhateverTheOtherTargetsAre)
{
    const lod::CoarseMesh from = lod::coarsen(fine, nothing, {180})[0];
    const std::vector<lod::CoarseMesh> many = lod::reduce_by_distance(surface, from, {100, 84, 60, 50, 30, 24, 14});
    const std::vector<lod::CoarseMesh> few = lod::reduce_by_distance(surface, from, {84, 30, 24});
    for (const auto &[a, b] : {std::pair(1, 0), std::pair(4, 1), std::pair(5, 2)}) {
        EXPECT_EQ(many[size_t(a)].surface.triangles, few[size_t(b)].surface.triangles) << a;
        EXPECT_EQ(many[size_t(a)].surface.positions, few[size_t(b)].surface.positions) << a;
    }
}

TEST_F(Reduce, IsTheSameEachTime)
{
    const lod::CoarseMesh from = lod::coarsen(fine, nothing, {100})[0];
    const lod::CoarseMesh a = lod::reduce_by_distance(surface, from, {40})[0],
                          b = lod::reduce_by_distance(surface, from, {40})[0];
    EXPECT_EQ(a.surface.triangles, b.surface.triangles);
    EXPECT_EQ(a.surface.positions, b.surface.positions);
}

TEST(OppositeFaces, AreMergedWhereTheyLieBackToBack)
{
    EXPECT_TRUE(lod::are_opposite({1, 2, 3}, {3, 2, 1}));
    EXPECT_TRUE(lod::are_opposite({1, 2, 3}, {2, 1, 3}));
    EXPECT_FALSE(lod::are_opposite({1, 2, 3}, {2, 3, 1}));
    const std::vector<lod::Triangle> tetrahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    EXPECT_EQ(lod::component_count(tetrahedron), 1u);
    EXPECT_TRUE(lod::merge_vertices(0, 1, tetrahedron).empty());
    std::vector<lod::Triangle> two = tetrahedron;
    for (const lod::Triangle &t : tetrahedron) two.push_back({t[0] + 3, t[1] + 3, t[2] + 3});
    EXPECT_EQ(lod::component_count(two), 2u);  // a common vertex is no common edge
    EXPECT_EQ(lod::merge_vertices(0, 6, two).size(), 8u);
}
