#include "lib/figures/figure.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

using namespace claque;

namespace
{

const model::Model &citizen()
{
    static const model::Model made = figures::citizen();
    return made;
}

}  // namespace

TEST(Citizen, passes_the_check_of_models) { EXPECT_NO_THROW(model::check(citizen())); }

TEST(Citizen, has_about_1040_triangles_33_bones_and_at_most_4_influences)
{
    ASSERT_EQ(citizen().parts.size(), 1u);
    const size_t triangles = model::triangles_of(citizen().parts[0]).size();
    EXPECT_GE(triangles, 950u);
    EXPECT_LE(triangles, 1100u);
    EXPECT_EQ(citizen().rig.node_count(), 33u);
    EXPECT_EQ(citizen().parts[0].influence_count, 4u);
}

TEST(Citizen, is_made_of_the_same_bytes_every_time)
{
    const model::Model again = figures::citizen();
    const model::Part &a = citizen().parts[0], &b = again.parts[0];
    EXPECT_EQ(citizen().images[0].rgba, again.images[0].rgba);
    EXPECT_EQ(a.indices, b.indices);
    EXPECT_EQ(a.joints, b.joints);
    EXPECT_EQ(a.weights, b.weights);
    ASSERT_EQ(a.positions.size(), b.positions.size());
    EXPECT_EQ(0, std::memcmp(a.positions.data(), b.positions.data(), a.positions.size() * sizeof(glm::vec3)));
    EXPECT_EQ(0, std::memcmp(a.normals.data(), b.normals.data(), a.normals.size() * sizeof(glm::vec3)));
    EXPECT_EQ(0, std::memcmp(a.uvs.data(), b.uvs.data(), a.uvs.size() * sizeof(glm::vec2)));
    ASSERT_EQ(citizen().rig.values.size(), again.rig.values.size());
    EXPECT_EQ(0, std::memcmp(citizen().rig.values.data(), again.rig.values.data(),
                             again.rig.values.size() * sizeof(float)));
}
