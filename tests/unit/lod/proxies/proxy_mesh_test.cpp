// The closed surface from which proxies are made.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/base/hash.h"
#include "lib/figures/figure.h"
#include "lib/lod/proxies/marching_tetrahedra.h"
#include "lib/lod/proxies/proxy.h"
#include "lib/lod/surface/nearest.h"
#include "lib/lod/surface/surface_samples.h"
#include "tests/unit/lod/proxies/closed.h"

using namespace claque;

namespace
{

using Triangles = std::vector<lod::Voxels::Triangle>;

// A box without its bottom.
Triangles open_box()
{
    const auto corner = [](int k) { return glm::dvec3(k & 1, k >> 1 & 1, k >> 2 & 1); };
    Triangles out;
    for (const auto &side : {std::array{0, 2, 6, 4}, {1, 5, 7, 3}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}}) {
        out.push_back({corner(side[0]), corner(side[1]), corner(side[2])});
        out.push_back({corner(side[0]), corner(side[2]), corner(side[3])});
    }
    return out;
}

double volume_of(const lod::ClosedMesh &boundary)
{
    double sum = 0;
    for (const auto &t : boundary.triangles)
        sum += glm::dot(boundary.positions[t[0]], glm::cross(boundary.positions[t[1]], boundary.positions[t[2]])) / 6;
    return sum;
}

}  // namespace

TEST(Voxels, FillABoxThatIsOpenBelowAndNothingOutside)
{
    const Triangles box = open_box();
    lod::Voxels voxels(box, 20);
    const glm::uvec3 size = voxels.size(), middle = size / 2u;
    EXPECT_FALSE(voxels.filled(middle.x, middle.y, middle.z));
    voxels.fill();
    EXPECT_TRUE(voxels.filled(middle.x, middle.y, middle.z));
    for (uint32_t x = 0; x < size.x; ++x)
        for (uint32_t y = 0; y < size.y; ++y)
            for (const uint32_t z : {0u, size.z - 1}) EXPECT_FALSE(voxels.filled(x, y, z));
}

TEST(ClosedMesh, EnclosesTheFilledCells)
{
    lod::Voxels voxels(open_box(), 20);
    voxels.fill();
    double filled = 0;
    const glm::uvec3 size = voxels.size();
    for (uint32_t z = 0; z < size.z; ++z)
        for (uint32_t y = 0; y < size.y; ++y)
            for (uint32_t x = 0; x < size.x; ++x) filled += voxels.filled(x, y, z);
    const lod::ClosedMesh boundary = lod::extract_closed_mesh(voxels);
    EXPECT_TRUE(test::is_closed(boundary, 1));
    const double cell = std::pow(voxels.cell(), 3);
    EXPECT_NEAR(volume_of(boundary) / cell, filled, 0.1 * filled);
    EXPECT_GT(volume_of(boundary), 0);  // from outside, its triangles are counter-clockwise
}

// Cells that touch only along edges and corners: other variants of marching tear there.
TEST(ClosedMesh, IsClosedHoweverCellsTouch)
{
    Triangles dust;
    for (uint64_t i = 0; i < 120; ++i) {
        const glm::dvec3 p(base::unit(base::mix(3 * i)), base::unit(base::mix(3 * i + 1)),
                           base::unit(base::mix(3 * i + 2)));
        dust.push_back({p, p, p});
    }
    const lod::ClosedMesh boundary = lod::extract_closed_mesh(lod::Voxels(dust, 8));
    EXPECT_GT(boundary.triangles.size(), 500u);
    EXPECT_TRUE(test::is_closed(boundary, 1));
}

TEST(ProxyMesh, IsTheSameWhateverTheOtherTargetsAre)
{
    const model::Model citizen = figures::citizen();
    std::vector<const model::Part *> parts;
    for (const model::Part &part : citizen.parts) parts.push_back(&part);
    lod::ProxyMeshOptions options;
    options.targets = {1100, 250, 165, 84, 42};
    const std::vector<model::Part> many = lod::proxy_meshes(citizen, parts, options);
    options.targets = {250, 42};
    const std::vector<model::Part> few = lod::proxy_meshes(citizen, parts, options);
    for (const auto &[a, b] : {std::pair(1, 0), std::pair(4, 1)}) {
        EXPECT_EQ(many[size_t(a)].positions, few[size_t(b)].positions) << a;
        EXPECT_EQ(many[size_t(a)].indices, few[size_t(b)].indices) << a;
    }
}

TEST(ProxyMesh, LevelsOfAPersonAreClosedAndLieNearIt)
{
    const model::Model citizen = figures::citizen();
    std::vector<const model::Part *> parts;
    for (const model::Part &part : citizen.parts) parts.push_back(&part);
    lod::ProxyMeshOptions options;
    options.targets = {250, 120, 60, 30, 20, 14};
    const std::vector<model::Part> shells = lod::proxy_meshes(citizen, parts, options);
    ASSERT_EQ(shells.size(), 6u);
    const std::vector<std::vector<glm::vec3>> own = lod::rest_positions(citizen.rig, parts);
    std::vector<lod::NearestPoint::Triangle> triangles;
    const lod::PosedParts posed(parts);
    for (const lod::PosedParts::Triangle &t : posed.triangles())
        triangles.push_back({glm::dvec3(own[t.part][t.vertices[0]]), glm::dvec3(own[t.part][t.vertices[1]]),
                             glm::dvec3(own[t.part][t.vertices[2]])});
    const lod::NearestPoint nearest(triangles);
    const double near_m[] = {0.08, 0.12, 0.15, 0.2, 0.2, 0.25};
    for (size_t i = 0; i < 6; ++i) {
        EXPECT_LE(shells[i].indices.size(), 3 * options.targets[i]);
        EXPECT_GE(shells[i].indices.size(), 3 * options.targets[i] * 9 / 10);
        lod::ClosedMesh surface;
        for (size_t k = 0; k < shells[i].indices.size(); k += 3)
            surface.triangles.push_back({shells[i].indices[k], shells[i].indices[k + 1], shells[i].indices[k + 2]});
        // Below 30 triangles an arm that touches the hip may leave an edge of four triangles.
        EXPECT_TRUE(options.targets[i] < 30 ? test::is_closed(surface) : test::is_closed(surface, 1));
        const std::vector<std::vector<glm::vec3>> rest = lod::rest_positions(citizen.rig, {&shells[i]});
        const auto by_height = [](const glm::vec3 &a, const glm::vec3 &b) { return a.y < b.y; };
        const auto [foot, head] = std::minmax_element(rest[0].begin(), rest[0].end(), by_height);
        EXPECT_NEAR(foot->y, 0, 0.15);  // a cone for two feet ends a little below them
        EXPECT_NEAR(head->y, 1.75, 0.15);
        for (const glm::vec3 p : rest[0]) EXPECT_LT(std::sqrt(nearest.to(glm::dvec3(p)).distance_squared), near_m[i]);
        for (size_t v = 0; v < shells[i].positions.size(); ++v) {
            float sum = 0;
            for (uint32_t k = 0; k < shells[i].influence_count; ++k)
                sum += shells[i].weights[v * shells[i].influence_count + k];
            EXPECT_NEAR(sum, 1, 1e-5);
        }
    }
}
