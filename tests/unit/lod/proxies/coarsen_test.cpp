// Closed surfaces of any shape reduced to a few triangles.
#include "lib/lod/proxies/coarsen.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/lod/proxies/closed.h"

using namespace claque;

namespace
{

// A row of intersecting rings: more handles than rings.
lod::ClosedMesh chain_of_rings(int rings)
{
    std::vector<lod::Voxels::Triangle> triangles;
    const auto ring = [](int r, double angle) { return glm::dvec3(1.9 * r + std::cos(angle), std::sin(angle), 0); };
    constexpr int steps = 48;
    for (int r = 0; r < rings; ++r)
        for (int i = 0; i < steps; ++i) {
            const glm::dvec3 a = ring(r, 6.28318530717958648 * i / steps),
                             b = ring(r, 6.28318530717958648 * (i + 1) / steps);
            triangles.push_back({a, b, a + glm::dvec3(0, 0, 0.2)});
        }
    return lod::extract_closed_mesh(lod::Voxels(triangles, 32));
}

glm::dvec3 extent(const lod::ClosedMesh &boundary)
{
    glm::dvec3 first(1e9), last(-1e9);
    for (const auto &t : boundary.triangles)
        for (const uint32_t v : t)
            first = glm::min(first, boundary.positions[v]), last = glm::max(last, boundary.positions[v]);
    return last - first;
}

}  // namespace

TEST(Coarsened, ReachesItsTargetForAnyNumberOfHandles)
{
    const lod::ClosedMesh rings = chain_of_rings(4);
    ASSERT_TRUE(test::is_closed(rings));
    const std::vector<size_t> targets = {250, 120, 60, 42, 30, 12};
    const std::vector<lod::CoarseMesh> levels =
        lod::coarsen(rings, std::vector<lod::Attributes>(rings.positions.size()), targets);
    ASSERT_EQ(levels.size(), targets.size());
    for (size_t k = 0; k < levels.size(); ++k) {
        const lod::CoarseMesh &level = levels[k];
        EXPECT_LE(level.surface.triangles.size(), targets[k]);
        EXPECT_GE(level.surface.triangles.size() * 3, targets[k]);
        EXPECT_TRUE(test::is_closed(level.surface)) << targets[k];
        ASSERT_EQ(level.features.size(), level.surface.positions.size());
        // Its length is kept, whatever happens to its holes.
        EXPECT_GT(extent(level.surface).x, (targets[k] > 12 ? 0.8 : 0.6) * extent(rings).x) << targets[k];
    }
}
