// Resizing never mixes zones (S2 2.3-2.4).
#include "meshsplit/pyramid.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "lib/base/hash.h"

namespace claque::test
{

using meshsplit::hole;
using meshsplit::ZoneMap;

namespace
{

ZoneMap noise(uint32_t width, uint32_t height, uint32_t zones, uint64_t seed)
{
    ZoneMap map(width, height);
    for (size_t i = 0; i < map.zones.size(); ++i) {
        const uint64_t h = base::mix(seed * 1000003 + i);
        map.zones[i] = h % 7 == 0 ? hole : uint16_t((h >> 8) % zones);
        for (size_t k = 0; k < 3; ++k) map.rgb[3 * i + k] = uint8_t(h >> (16 + 8 * k));
    }
    return map;
}

}  // namespace

TEST(Pyramid, ASmallerTexelHasAZoneOfTheMajorityOfItsFourAndTheMeanRgbOfThatZone)
{
    for (uint64_t seed = 0; seed < 20; ++seed) {
        const ZoneMap big = noise(32, 16, 1 + seed % 5, seed);
        const ZoneMap small = meshsplit::halve(big);
        ASSERT_EQ(small.width, 16u);
        ASSERT_EQ(small.height, 8u);
        for (uint32_t y = 0; y < 8; ++y)
            for (uint32_t x = 0; x < 16; ++x) {
                const size_t at = y * 16 + x;
                std::vector<size_t> four;
                for (const uint32_t dy : {0u, 1u})
                    for (const uint32_t dx : {0u, 1u}) four.push_back((2 * y + dy) * 32 + 2 * x + dx);
                const auto votes = [&](uint16_t zone) {
                    return std::count_if(four.begin(), four.end(), [&](size_t i) { return big.zones[i] == zone; });
                };
                const auto own = votes(small.zones[at]);
                ASSERT_GT(own, 0) << "a key appears that was not among the four";
                for (const size_t i : four) ASSERT_LE(votes(big.zones[i]), own);
                for (size_t k = 0; k < 3; ++k) {
                    double sum = 0;
                    for (const size_t i : four)
                        if (big.zones[i] == small.zones[at]) sum += big.rgb[3 * i + k];
                    ASSERT_NEAR(small.rgb[3 * at + k], sum / double(own), 0.5001);
                }
            }
    }
}

TEST(Pyramid, TiesGoToTheZoneOfTheLargerNeighbourhoodThenToTheLowerNumber)
{
    ZoneMap map(6, 6);
    std::fill(map.zones.begin(), map.zones.end(), uint16_t(9));
    // The middle box is half 9, half 4; all around is 9.
    map.zones[2 * 6 + 2] = map.zones[3 * 6 + 3] = 4;
    EXPECT_EQ(meshsplit::halve(map).zones[1 * 3 + 1], 9);
    ZoneMap right(6, 2);
    right.zones = {7, 7, 4, 9, 9, 9, 7, 7, 4, 9, 9, 9};
    EXPECT_EQ(meshsplit::halve(right).zones[1], 9) << "the neighbourhood reaches to both sides";
    ZoneMap two(2, 1);
    two.zones = {5, 3};
    EXPECT_EQ(meshsplit::halve(two).zones[0], 3);
}

TEST(Pyramid, ResamplingToOddRatiosTakesZoneAndRgbFromTheBoxAlone)
{
    for (const uint32_t size : {8u, 16u, 64u}) {
        const ZoneMap from = noise(37, 23, 4, size);
        const ZoneMap to = meshsplit::resample(from, size, size);
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x) {
                uint8_t low[3] = {255, 255, 255}, high[3] = {0, 0, 0};
                bool found = false;
                for (uint32_t sy = y * 23 / size; sy * size < (y + 1) * 23; ++sy)
                    for (uint32_t sx = x * 37 / size; sx * size < (x + 1) * 37; ++sx) {
                        if (from.zones[sy * 37 + sx] != to.zones[y * size + x]) continue;
                        found = true;
                        for (int k = 0; k < 3; ++k) {
                            low[k] = std::min(low[k], from.rgb[3 * (sy * 37 + sx) + uint32_t(k)]);
                            high[k] = std::max(high[k], from.rgb[3 * (sy * 37 + sx) + uint32_t(k)]);
                        }
                    }
                ASSERT_TRUE(found);
                for (int k = 0; k < 3; ++k) {
                    ASSERT_GE(to.rgb[3 * (y * size + x) + uint32_t(k)], low[k]);
                    ASSERT_LE(to.rgb[3 * (y * size + x) + uint32_t(k)], high[k]);
                }
            }
    }
}

TEST(Pyramid, FittingGivesPowersOfTwoAndLeavesThoseAlone)
{
    const ZoneMap odd = meshsplit::fit(noise(300, 130, 3, 1), 1024);
    EXPECT_EQ(odd.width, 512u);
    EXPECT_EQ(odd.height, 256u);
    const ZoneMap large = meshsplit::fit(noise(512, 64, 3, 1), 128);
    EXPECT_EQ(large.width, 128u);
    EXPECT_EQ(large.height, 64u);
    const ZoneMap thin = meshsplit::fit(noise(1000, 3, 3, 1), 64);
    EXPECT_EQ(thin.width, 64u);
    EXPECT_EQ(thin.height, 4u);
    const ZoneMap same = noise(64, 32, 3, 1);
    EXPECT_EQ(meshsplit::fit(same, 64).rgb, same.rgb);
    EXPECT_EQ(meshsplit::fit(same, 64).zones, same.zones);
}

TEST(Pyramid, GuttersCarryTheNearestCoveredTexel)
{
    for (uint64_t seed = 0; seed < 12; ++seed) {
        ZoneMap map = noise(24, 17, 200, seed);
        for (size_t i = 0; i < map.zones.size(); ++i) map.zones[i] = uint16_t(i);  // each texel records its origin
        std::vector<uint8_t> covered(map.zones.size());
        for (size_t i = 0; i < covered.size(); ++i) covered[i] = base::mix(seed * 77 + i) % (3 + 9 * seed) == 0;
        covered[5] = 1;
        const ZoneMap before = map;
        meshsplit::dilate(map, covered);
        for (int y = 0; y < 17; ++y)
            for (int x = 0; x < 24; ++x) {
                const size_t at = size_t(y * 24 + x), from = map.zones[at];
                ASSERT_TRUE(covered[from]);
                ASSERT_TRUE(!covered[at] || from == at);
                const auto distance = [&](size_t i) {
                    const int dx = int(i % 24) - x, dy = int(i / 24) - y;
                    return dx * dx + dy * dy;
                };
                for (size_t i = 0; i < covered.size(); ++i)
                    ASSERT_TRUE(!covered[i] || distance(from) <= distance(i)) << x << ' ' << y;
                for (size_t k = 0; k < 3; ++k) ASSERT_EQ(map.rgb[3 * at + k], before.rgb[3 * from + k]);
            }
    }
}

TEST(Pyramid, WithoutAnythingCoveredNothingIsFilled)
{
    ZoneMap map = noise(8, 8, 3, 4);
    const ZoneMap before = map;
    meshsplit::dilate(map, std::vector<uint8_t>(64, 0));
    EXPECT_EQ(map.zones, before.zones);
}

TEST(Pyramid, UnfoldingMirrors)
{
    const ZoneMap map = noise(4, 2, 3, 4);
    const ZoneMap out = meshsplit::unfold(map, true, true);
    ASSERT_EQ(out.width, 8u);
    ASSERT_EQ(out.height, 4u);
    for (uint32_t y = 0; y < 4; ++y)
        for (uint32_t x = 0; x < 8; ++x)
            EXPECT_EQ(out.zones[y * 8 + x], map.zones[(y < 2 ? y : 3 - y) * 4 + (x < 4 ? x : 7 - x)]);
}

}  // namespace claque::test
