// The citizen: mesh, normals and weights.

#include <set>

#include <gtest/gtest.h>

#include "person.h"

using namespace claque;

namespace figure_test
{
using puppet::citizen;

namespace
{

const model::Part &part() { return citizen().parts[0]; }

}  // namespace

TEST(Citizen, Stands1Point75MTallOnTheGroundBetweenItsFeet)
{
    glm::vec3 low(1e9f), high(-1e9f);
    for (const glm::vec3 p : part().positions) low = min(low, p), high = max(high, p);
    EXPECT_FLOAT_EQ(low.y, 0);
    EXPECT_NEAR(high.y, 1.75f, 0.02f);
    EXPECT_NEAR(low.x + high.x, 0, 1e-4f);
}

TEST(Citizen, MovesSomethingWithEveryBoneButTheRoot)
{
    std::set<uint32_t> used;
    for (size_t k = 0; k < part().weights.size(); ++k)
        if (part().weights[k] > 0) used.insert(part().joints[k]);
    EXPECT_EQ(used.size(), 32u);
}

// Open edges: the arms' and legs' upper ends inside sleeve and skirt, the roots of thumbs and index fingers inside the
// palm, and the ears' edges against the head.
TEST(Citizen, IsClosedButForEdgesThatAreHidden)
{
    const int doubled = puppet::for_open_edges(part(), [](uint32_t v) {
        const auto [x, y, z] = puppet::place(part(), v);
        const glm::vec3 at(std::fabs(x), y, z);
        const bool under_skirt = y > 0.60f && y < 0.70f && at.x < 0.17f;
        const bool in_sleeve = glm::distance(at, glm::vec3(0.292f, 1.305f, -0.012f)) < 0.06f;
        const bool in_palm = glm::distance(at, glm::vec3(0.60f, 1.00f, 0.02f)) < 0.07f;
        const bool ear = at.x > 0.06f && y > 1.58f && y < 1.66f;
        EXPECT_TRUE(under_skirt || in_sleeve || in_palm || ear) << "open at " << x << ' ' << y << ' ' << z;
    });
    EXPECT_EQ(doubled, 0) << "an edge is used twice the same way";
}

}  // namespace figure_test
