// Comparison by regions: the inner pixels of one individual.
#include "samples/parity/regions.h"

#include <gtest/gtest.h>

#include "tests/unit/parity/test_pictures.h"

namespace parity
{
namespace
{

// Two columns of ids in 20 x 10: 1 left, 2 right; inner pixels are those not at the seam.
Map<uint64_t> halves()
{
    Map<uint64_t> out(20, 10, 1);
    for (int y = 0; y < 10; ++y)
        for (int x = 10; x < 20; ++x) out.values[out.index(x, y)] = 2;
    return out;
}

TEST(Regions, TheWorstOneIsFoundByItsMean)
{
    const Picture plain = filled(20, 10, 100);
    Picture other = plain;
    const Map<uint64_t> ids = halves();
    for (size_t i = 0; i < ids.values.size(); ++i)
        if (ids.values[i] == 2) other.rgb[3 * i + 1] = 104;
    other.rgb[0] = 200;
    const WorstRegion worst = worst_colour(ids, plain, other, {});
    EXPECT_EQ(worst.regions, 2u);
    EXPECT_EQ(worst.id, 2u);
    EXPECT_EQ(worst.pixels, 90u);
    EXPECT_DOUBLE_EQ(worst.value, 4);
}

TEST(Regions, WhatLiesAtABorderBelongsToNone)
{
    const Picture plain = filled(20, 10, 100);
    Picture other = plain;
    for (size_t y = 0; y < 10; ++y)
        for (size_t c = 0; c < 3; ++c) other.rgb[3 * (y * 20 + 10) + c] = 0;
    EXPECT_EQ(worst_colour(halves(), plain, other, {}).value, 0);
}

TEST(Regions, SmallOnesAreIgnored)
{
    Map<uint64_t> ids(20, 10, 0);
    for (int y = 4; y < 8; ++y)
        for (int x = 4; x < 7; ++x) ids.values[ids.index(x, y)] = 7;  // 3 x 4: two inner pixels
    const Picture plain = filled(20, 10, 100), black = filled(20, 10, 0);
    EXPECT_EQ(worst_colour(ids, plain, black, {}).regions, 1u);
    for (int y = 4; y < 8; ++y) ids.values[ids.index(7, y)] = 7;  // 4 x 4: four
    EXPECT_EQ(worst_colour(ids, plain, black, {}).regions, 2u);
}

TEST(Regions, PixelsThatDoNotCountBelongToNone)
{
    const Picture plain = filled(20, 10, 100), other = filled(20, 10, 104);
    const Map<uint64_t> ids = halves();
    Counted left;
    for (const uint64_t id : ids.values) left.push_back(id == 1);
    EXPECT_EQ(worst_colour(ids, plain, other, left).regions, 1u);
    EXPECT_EQ(worst_bias(ids, plain, other, left).regions, 1u);
    EXPECT_EQ(worst_ids(ids, ids, left).regions, 1u);
    EXPECT_EQ(worst_depth(ids, Map<float>(20, 10, 0.5f), Map<float>(20, 10, 0.5f), left).regions, 1u);
}

TEST(Regions, ABiasIsWhatDoesNotCancelOut)
{
    const Picture plain = filled(20, 10, 100);
    Picture other = plain;
    const Map<uint64_t> ids = halves();
    for (size_t i = 0; i < ids.values.size(); ++i) {
        if (ids.values[i] == 1) other.rgb[3 * i] = i % 2 == 0 ? 130 : 70;  // texels elsewhere
        else if (i % 20 < 15) other.rgb[3 * i + 1] = 96;                   // half of the region is darker
    }
    const WorstRegion worst = worst_bias(ids, plain, other, {});
    EXPECT_EQ(worst.id, 2u);
    EXPECT_EQ(worst.pixels, 100u);  // with the pixels at the seam
    EXPECT_DOUBLE_EQ(worst.value, 2);
    EXPECT_EQ(worst_colour(ids, plain, other, {}).id, 1u);
}

TEST(Regions, ABiasNeedsSixteenPixels)
{
    const Picture plain = filled(20, 10, 100), black = filled(20, 10, 0);
    Map<uint64_t> ids(20, 10, 0);
    for (int x = 0; x < 15; ++x) ids.values[ids.index(x, 4)] = 7;
    EXPECT_EQ(worst_bias(ids, plain, black, {}).regions, 1u);
    ids.values[ids.index(15, 4)] = 7;
    EXPECT_EQ(worst_bias(ids, plain, black, {}).regions, 2u);
}

TEST(Regions, OfIdsTheWorstHasTheLargestShareOfOthers)
{
    const Map<uint64_t> ids = halves();
    Map<uint64_t> other = ids;
    for (int y = 0; y < 10; ++y) {
        other.values[other.index(10, y)] = 1;  // at the seam
        for (int x = 11; x < 14; ++x) other.values[other.index(x, y)] = 5;
    }
    const WorstRegion worst = worst_ids(ids, other, {});
    EXPECT_EQ(worst.regions, 2u);
    EXPECT_EQ(worst.id, 2u);
    EXPECT_EQ(worst.pixels, 90u);
    EXPECT_DOUBLE_EQ(worst.value, 30.0 / 90);
}

TEST(Regions, DepthGoesByMedians)
{
    Map<float> a(20, 10, 0.5f), b = a;
    const Map<uint64_t> ids = halves();
    for (size_t i = 0; i < ids.values.size(); ++i)
        if (ids.values[i] == 1) b.values[i] = 0.625f;
    b.values[19] = 0;
    const WorstRegion worst = worst_depth(ids, a, b, {});
    EXPECT_EQ(worst.id, 1u);
    EXPECT_EQ(worst.value, 0.125);
}

}  // namespace
}  // namespace parity
