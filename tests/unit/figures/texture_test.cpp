// The citizen's texture: zone keys, texture sets and charts.
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "puppet.h"

using namespace claque;

namespace texture_test
{
using puppet::citizen;

namespace
{

constexpr int size = 512;

float cross2(glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; }

// Calls with the index of every texel whose centre lies inside the triangle.
template <class Visit>
void texels(const std::array<uint32_t, 3> &t, Visit visit)
{
    glm::vec2 p[3];
    for (size_t k = 0; k < 3; ++k) p[k] = citizen().parts[0].uvs[t[k]] * float(size);
    const float area = cross2(p[1] - p[0], p[2] - p[0]);
    if (area == 0) return;
    for (int y = 0; y < size; ++y) {
        if (y + 1 < std::min({p[0].y, p[1].y, p[2].y}) || y > std::max({p[0].y, p[1].y, p[2].y})) continue;
        for (int x = 0; x < size; ++x) {
            const glm::vec2 c(float(x) + 0.5f, float(y) + 0.5f);
            const float a = cross2(p[1] - c, p[2] - c) / area, b = cross2(p[2] - c, p[0] - c) / area;
            constexpr float inside = 1e-3f;
            if (a > inside && b > inside && 1 - a - b > inside) visit(y * size + x);
        }
    }
}

const std::vector<uint8_t> &pixels() { return citizen().images[0].rgba; }

}  // namespace

TEST(CitizenTexture, HoldsTheKeysOfAllEightZonesAndNoOthers)
{
    EXPECT_EQ(citizen().images[0].width, 512u);
    EXPECT_EQ(citizen().images[0].height, 512u);
    EXPECT_EQ(citizen().images[0].alpha, model::AlphaMeaning::zone_keys);
    std::set<std::string> names;
    std::set<int> keys, found;
    for (const model::Zone &z : citizen().zones) names.insert(z.name), keys.insert(z.key);
    EXPECT_EQ(names, (std::set<std::string>{"skin", "hair", "eyes", "lips", "tunic", "belt", "border", "sandals"}));
    for (size_t i = 3; i < pixels().size(); i += 4) found.insert(pixels()[i]);
    EXPECT_EQ(found, keys);
}

TEST(CitizenTexture, HasASecondSetOfTheSameSizeAndKeysThatShowsOtherZonesHereAndThere)
{
    ASSERT_EQ(citizen().texture_sets.size(), 1u);
    const model::Image &second = citizen().images.at(citizen().texture_sets[0].images.at(0));
    ASSERT_EQ(second.rgba.size(), pixels().size());
    std::set<int> keys, found;
    for (const model::Zone &z : citizen().zones) keys.insert(z.key);
    size_t other = 0;
    for (size_t i = 3; i < pixels().size(); i += 4) {
        found.insert(second.rgba[i]);
        other += second.rgba[i] != pixels()[i];
    }
    EXPECT_EQ(found, keys);
    EXPECT_GT(other, pixels().size() / 4 / 100);  // a beard, bands: more than one texel in a hundred
    EXPECT_LT(other, pixels().size() / 4 / 5);
}

TEST(CitizenTexture, ShowsEveryZoneOnSomeTriangle)
{
    std::map<int, int> shown;
    for (const auto &t : model::triangles_of(citizen().parts[0]))
        texels(t, [&](int i) { ++shown[pixels()[4 * size_t(i) + 3]]; });
    for (const model::Zone &z : citizen().zones) EXPECT_GT(shown[z.key], 60) << z.name;
}

TEST(CitizenTexture, NeverLaysOneTriangleOverAnother)
{
    std::vector<int> owner(size * size, -1);
    int index = 0, overlaps = 0;
    for (const auto &t : model::triangles_of(citizen().parts[0])) {
        texels(t, [&](int i) {
            if (owner[size_t(i)] >= 0) {
                ++overlaps;
                if (overlaps < 12) {
                    const glm::vec3 p = citizen().parts[0].positions[t[0]];
                    ADD_FAILURE() << "texel " << i % size << ' ' << i / size << " near " << p.x << ' ' << p.y << ' '
                                  << p.z;
                }
            }
            owner[size_t(i)] = index;
        });
        ++index;
    }
    EXPECT_EQ(overlaps, 0);
}

TEST(CitizenTexture, KeepsItsCoordinatesInsideTheImage)
{
    for (const glm::vec2 uv : citizen().parts[0].uvs) {
        EXPECT_GE(uv.x, 0);
        EXPECT_LE(uv.x, 1);
        EXPECT_GE(uv.y, 0);
        EXPECT_LE(uv.y, 1);
    }
}

TEST(CitizenTexture, IsGreyLightAndMostlyBright)
{
    size_t bright = 0;
    for (size_t i = 0; i < pixels().size(); i += 4) {
        ASSERT_EQ(pixels()[i], pixels()[i + 1]);
        ASSERT_EQ(pixels()[i], pixels()[i + 2]);
        bright += pixels()[i] >= 150;
    }
    EXPECT_GT(bright, pixels().size() / 4 * 7 / 10);
}

}  // namespace texture_test
