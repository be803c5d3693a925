// The citizen's texture: zone keys, texture sets and charts.
#include <set>

#include <gtest/gtest.h>

#include "puppet.h"

using namespace claque;

namespace texture_test
{
using puppet::citizen;

namespace
{

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

TEST(CitizenTexture, KeepsItsCoordinatesInsideTheImage)
{
    for (const glm::vec2 uv : citizen().parts[0].uvs) {
        EXPECT_GE(uv.x, 0);
        EXPECT_LE(uv.x, 1);
        EXPECT_GE(uv.y, 0);
        EXPECT_LE(uv.y, 1);
    }
}

}  // namespace texture_test
