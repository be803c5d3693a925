// The citizen: mesh, normals and weights.
#include <cstring>
#include <map>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "puppet.h"

using namespace claque;

namespace figure_test
{
using puppet::citizen;

namespace
{

const model::Part &part() { return citizen().parts[0]; }

using Place = std::tuple<float, float, float>;
Place place(uint32_t v) { return {part().positions[v].x, part().positions[v].y, part().positions[v].z}; }

}  // namespace

TEST(Citizen, PassesTheCheckOfModels) { EXPECT_NO_THROW(model::check(citizen())); }

TEST(Citizen, HasAbout1040Triangles33BonesAndAtMost4Influences)
{
    ASSERT_EQ(citizen().parts.size(), 1u);
    const size_t triangles = model::triangles_of(part()).size();
    EXPECT_GE(triangles, 950u);
    EXPECT_LE(triangles, 1100u);
    EXPECT_EQ(citizen().rig.node_count(), 33u);
    EXPECT_EQ(part().influence_count, 4u);
    std::set<uint32_t> used;
    for (size_t v = 0; v < part().positions.size(); ++v)
        for (size_t k = 0; k < 4; ++k)
            if (part().weights[4 * v + k] > 0) used.insert(part().joints[4 * v + k]);
    EXPECT_EQ(used.size(), 32u) << "every bone but the root moves something";
}

TEST(Citizen, Stands1Point75MTallOnTheGroundBetweenItsFeet)
{
    glm::vec3 low(1e9f), high(-1e9f);
    for (const glm::vec3 p : part().positions) low = min(low, p), high = max(high, p);
    EXPECT_FLOAT_EQ(low.y, 0);
    EXPECT_NEAR(high.y, 1.75f, 0.02f);
    EXPECT_NEAR(low.x + high.x, 0, 1e-4f);
}

TEST(Citizen, HasNoDegenerateTriangle)
{
    for (const auto &t : model::triangles_of(part())) {
        const glm::vec3 a = part().positions[t[0]];
        const glm::vec3 n = glm::cross(part().positions[t[1]] - a, part().positions[t[2]] - a);
        EXPECT_GT(glm::length(n), 2e-6f) << "near " << a.x << ' ' << a.y << ' ' << a.z;
    }
}

TEST(Citizen, HasUnitNormalsThatAgreeWithItsTriangles)
{
    size_t against = 0;
    for (const glm::vec3 n : part().normals) EXPECT_NEAR(glm::length(n), 1, 1e-4f);
    for (const auto &t : model::triangles_of(part())) {
        const glm::vec3 a = part().positions[t[0]];
        const glm::vec3 n = glm::cross(part().positions[t[1]] - a, part().positions[t[2]] - a);
        for (const uint32_t v : t) against += glm::dot(n, part().normals[v]) < 0;
    }
    EXPECT_LE(against, 12u) << "a few corners of thin fingers and ears may look away";
}

// Open edges: the arms' and legs' upper ends inside sleeve and skirt, the roots of thumbs and index fingers inside the
// palm, and the ears' edges against the head.
TEST(Citizen, IsClosedButForEdgesThatAreHidden)
{
    std::map<std::pair<Place, Place>, int> edges;
    for (const auto &t : model::triangles_of(part()))
        for (size_t k = 0; k < 3; ++k) {
            const Place a = place(t[k]), b = place(t[(k + 1) % 3]);
            ++edges[{a, b}];
        }
    for (const auto &[edge, count] : edges) {
        EXPECT_EQ(count, 1) << "an edge is used twice the same way";
        if (edges.count({edge.second, edge.first})) continue;
        const auto [x, y, z] = edge.first;
        const glm::vec3 at(std::fabs(x), y, z);
        const bool under_skirt = y > 0.60f && y < 0.70f && at.x < 0.17f;
        const bool in_sleeve = glm::distance(at, glm::vec3(0.292f, 1.305f, -0.012f)) < 0.06f;
        const bool in_palm = glm::distance(at, glm::vec3(0.60f, 1.00f, 0.02f)) < 0.07f;
        const bool ear = at.x > 0.06f && y > 1.58f && y < 1.66f;
        EXPECT_TRUE(under_skirt || in_sleeve || in_palm || ear) << "open at " << x << ' ' << y << ' ' << z;
    }
}

TEST(Citizen, KeepsWeightsEqualWhereverVerticesShareAPositionOnTheSkin)
{
    std::map<Place, uint32_t> first;
    for (uint32_t v = 0; v < part().positions.size(); ++v) {
        const auto [at, fresh] = first.try_emplace(place(v), v);
        if (fresh) continue;
        const auto total = [](uint32_t vertex, uint32_t bone) {
            float sum = 0;
            for (size_t k = 0; k < 4; ++k)
                if (part().joints[4 * vertex + k] == bone) sum += part().weights[4 * vertex + k];
            return sum;
        };
        for (uint32_t bone = 0; bone < 33; ++bone)
            EXPECT_NEAR(total(v, bone), total(at->second, bone), 1e-5f) << "seam would tear at vertex " << v;
    }
}

TEST(Citizen, IsMadeOfTheSameBytesEveryTime)
{
    const model::Model again = figures::citizen();
    const model::Part &b = again.parts[0];
    EXPECT_EQ(citizen().images[0].rgba, again.images[0].rgba);
    EXPECT_EQ(part().indices, b.indices);
    EXPECT_EQ(part().joints, b.joints);
    EXPECT_EQ(part().weights, b.weights);
    const auto same = [](const auto &x, const auto &y) {
        return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0;
    };
    EXPECT_TRUE(same(part().positions, b.positions));
    EXPECT_TRUE(same(part().normals, b.normals));
    EXPECT_TRUE(same(part().uvs, b.uvs));
    EXPECT_TRUE(same(citizen().rig.values, again.rig.values));
}

}  // namespace figure_test
