// Comparison of id maps, with a tolerance at borders.
#include "samples/parity/ids.h"

#include <gtest/gtest.h>

namespace parity
{
namespace
{

// A square of this id in a picture of 20 x 20.
Map<uint64_t> square(int left, int top, int side, uint64_t id)
{
    Map<uint64_t> out(20, 20);
    for (int y = top; y < top + side; ++y)
        for (int x = left; x < left + side; ++x) out.values[out.index(x, y)] = id;
    return out;
}

TEST(Ids, EqualMapsDifferNowhere)
{
    const IdAgreement ids = compare_ids(square(5, 5, 8, 3), square(5, 5, 8, 3), {});
    EXPECT_EQ(ids.compared, 400u);
    EXPECT_EQ(ids.different, 0u);
    EXPECT_EQ(ids.borders, 28u + 36u);  // the square's rim and the pixels round it
}

TEST(Ids, ABorderMayLieAPixelFurtherOn)
{
    const IdAgreement ids = compare_ids(square(5, 5, 8, 3), square(6, 5, 8, 3), {});
    EXPECT_EQ(ids.different, 16u);
    EXPECT_EQ(ids.outside, 0u);
    EXPECT_DOUBLE_EQ(ids.border_share(), 16.0 / 64);
    EXPECT_EQ(ids.marks.at(5, 7), Mark::border);
    EXPECT_EQ(ids.marks.at(6, 7), Mark::same);
}

TEST(Ids, ABorderTwoPixelsFurtherOnIsNone)
{
    const IdAgreement ids = compare_ids(square(5, 5, 8, 3), square(7, 5, 8, 3), {});
    EXPECT_EQ(ids.different, 32u);
    EXPECT_EQ(ids.outside,
              // at the left, those not adjacent to the pixels round the square; at the right, all of the added column
              6u + 8u);
    EXPECT_EQ(ids.first_x, 14);
    EXPECT_EQ(ids.first_y, 5);
}

TEST(Ids, AtABorderOnlyWhatMeetsThereMayShow)
{
    Map<uint64_t> stranger = square(5, 5, 8, 3);
    stranger.values[stranger.index(5, 7)] = 9;
    const IdAgreement ids = compare_ids(square(5, 5, 8, 3), stranger, {});
    EXPECT_EQ(ids.outside, 1u);
    EXPECT_EQ(ids.marks.at(5, 7), Mark::outside);
}

TEST(Ids, AnotherIndividualIsOutsideEverywhere)
{
    EXPECT_EQ(compare_ids(square(5, 5, 8, 3), square(5, 5, 8, 4), {}).outside, 64u);
    EXPECT_EQ(compare_ids(square(5, 5, 8, 3), Map<uint64_t>(20, 20), {}).outside, 36u);  // the rim may be background
}

TEST(Ids, PixelsThatDoNotCountAreNotCounted)
{
    std::vector<uint8_t> some(400, 1);
    some[0] = 0;
    Map<uint64_t> other = square(5, 5, 8, 3);
    other.values[0] = 7;
    const IdAgreement ids = compare_ids(square(5, 5, 8, 3), other, some);
    EXPECT_EQ(ids.compared, 399u);
    EXPECT_EQ(ids.different, 0u);
    EXPECT_EQ(ids.marks.values[0], Mark::ignored);
}

TEST(Ids, ANeighboursZoneIsAnError)
{
    Map<uint32_t> actor(4, 1, 1);
    actor.values[3] = 2;
    Map<uint16_t> zone(4, 1, 5);
    zone.values[3] = 6;
    Map<uint16_t> wrong = zone;
    wrong.values[2] = 6;
    EXPECT_EQ(compare_ids(zone_ids(actor, zone), zone_ids(actor, wrong), {}).outside, 1u);
}

}  // namespace
}  // namespace parity
