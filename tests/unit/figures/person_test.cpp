// What every built-in person has: its size, a surface that holds together, and a texture that colours can be seen on.
#include "person.h"

#include <cstring>

#include <gtest/gtest.h>

using namespace claque;

namespace claque::figures
{

void PrintTo(const Builtin &builtin, std::ostream *out) { *out << builtin.name; }

}  // namespace claque::figures

namespace person_test
{

namespace
{

class Person : public testing::TestWithParam<figures::Builtin>
{
protected:
    const model::Model person = GetParam().make();
    const model::Part &part = person.parts[0];

    float weight_of(uint32_t vertex, uint32_t bone) const
    {
        float sum = 0;
        for (size_t k = 0; k < 4; ++k)
            if (part.joints[4 * vertex + k] == bone) sum += part.weights[4 * vertex + k];
        return sum;
    }
};

INSTANTIATE_TEST_SUITE_P(BuiltIn, Person, testing::ValuesIn(figures::people()),
                         [](const auto &info) { return std::string(info.param.name); });

TEST_P(Person, HasAbout1040Triangles33BonesAndAtMost4Influences)
{
    EXPECT_NO_THROW(model::check(person));
    ASSERT_EQ(person.parts.size(), 1u);
    EXPECT_GE(model::triangles_of(part).size(), 950u);
    EXPECT_LE(model::triangles_of(part).size(), 1100u);
    EXPECT_EQ(part.influence_count, 4u);
    EXPECT_EQ(person.rig.node_count(), 33u);
    for (size_t v = 0; v < part.positions.size(); ++v) {
        float sum = 0;
        for (size_t k = 0; k < 4; ++k) sum += part.weights[4 * v + k];
        EXPECT_NEAR(sum, 1, 1e-5f);
    }
}

TEST_P(Person, SharesItsSkeletonAndClipsWithTheCitizen)
{
    EXPECT_EQ(person.rig.node_names, puppet::citizen().rig.node_names);
    EXPECT_EQ(person.rig.clip_names, puppet::citizen().rig.clip_names);
}

TEST_P(Person, HasNoDegenerateTriangleAndUnitNormalsThatAgree)
{
    size_t against = 0;
    for (const glm::vec3 n : part.normals) EXPECT_NEAR(glm::length(n), 1, 1e-4f);
    for (const auto &t : model::triangles_of(part)) {
        const glm::vec3 a = part.positions[t[0]];
        const glm::vec3 n = glm::cross(part.positions[t[1]] - a, part.positions[t[2]] - a);
        EXPECT_GT(glm::length(n), 2e-6f) << "near " << a.x << ' ' << a.y << ' ' << a.z;
        for (const uint32_t v : t) against += glm::dot(n, part.normals[v]) < 0;
    }
    EXPECT_LE(against, 16u) << "a few corners of thin fingers and ears may look away";
}

TEST_P(Person, KeepsWeightsEqualWhereverVerticesShareAPosition)
{
    std::map<puppet::Place, uint32_t> first;
    for (uint32_t v = 0; v < part.positions.size(); ++v) {
        const auto [at, fresh] = first.try_emplace(puppet::place(part, v), v);
        if (fresh) continue;
        for (uint32_t bone = 0; bone < 33; ++bone)
            EXPECT_NEAR(weight_of(v, bone), weight_of(at->second, bone), 1e-5f) << "seam would tear at vertex " << v;
    }
}

TEST_P(Person, IsMadeOfTheSameBytesEveryTime)
{
    const model::Model again = GetParam().make();
    const model::Part &b = again.parts[0];
    EXPECT_EQ(person.images[0].rgba, again.images[0].rgba);
    EXPECT_EQ(part.indices, b.indices);
    EXPECT_EQ(part.joints, b.joints);
    EXPECT_EQ(part.weights, b.weights);
    const auto same = [](const auto &x, const auto &y) {
        return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0;
    };
    EXPECT_TRUE(same(part.positions, b.positions));
    EXPECT_TRUE(same(part.normals, b.normals));
    EXPECT_TRUE(same(part.uvs, b.uvs));
    EXPECT_TRUE(same(person.rig.values, again.rig.values));
}

TEST_P(Person, ShowsEachOfItsZonesAndNoOtherKey)
{
    std::map<int, int> shown;
    for (const auto &t : model::triangles_of(part))
        puppet::for_texels(part, t, [&](size_t i) { ++shown[person.images[0].rgba[4 * i + 3]]; });
    for (const model::Zone &z : person.zones) EXPECT_GT(shown[z.key], 60) << z.name;
    EXPECT_EQ(shown.size(), person.zones.size());
}

TEST_P(Person, LaysNoTriangleOverAnotherInItsTexture)
{
    std::vector<uint8_t> taken(size_t(puppet::texture_px) * puppet::texture_px, 0);
    size_t overlaps = 0;
    glm::vec3 where(0);
    for (const auto &t : model::triangles_of(part))
        puppet::for_texels(part, t, [&](size_t i) {
            if (taken[i]) ++overlaps, where = part.positions[t[0]];
            taken[i] = 1;
        });
    EXPECT_EQ(overlaps, 0u) << "last near " << where.x << ' ' << where.y << ' ' << where.z;
}

TEST_P(Person, HasAGreyAndLightTextureSoThatColoursReachTheEye)
{
    const std::vector<uint8_t> &pixels = person.images[0].rgba;
    size_t bright = 0;
    for (size_t i = 0; i < pixels.size(); i += 4) {
        ASSERT_EQ(pixels[i], pixels[i + 1]);
        ASSERT_EQ(pixels[i], pixels[i + 2]);
        bright += pixels[i] >= 150;
    }
    EXPECT_GT(bright, pixels.size() / 4 * 7 / 10);
}

}  // namespace

}  // namespace person_test
