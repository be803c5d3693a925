// The seats of the amphitheatre lie within its published plan, apart from each other, and clear of stairs and openings.
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "samples/scenes/amphitheatre/spectators.h"

namespace
{

using namespace scenes;
using namespace scenes::amphitheatre;

const Plan &plan()
{
    static const Plan made;
    return made;
}

const std::vector<amphitheatre::Seat> &seats()
{
    static const std::vector<amphitheatre::Seat> made = plan().seats();
    return made;
}

TEST(AmphitheatrePlan, ATurnAndADistanceAreFoundAgainFromTheirPoint)
{
    for (double turn = 0.01; turn < 6.28; turn += 0.083)
        for (const double out : {-3.0, 0.0, 20.0, building_m}) {
            const Spot spot = plan().oval().at(turn, out);
            const Bearing found = plan().oval().bearing(spot.x, spot.z);
            EXPECT_NEAR(found.turn, turn, 1e-9);
            EXPECT_NEAR(found.out, out, 1e-9);
            EXPECT_NEAR(plan().oval().turn_at(plan().oval().length(turn, out), out), turn, 1e-9);
        }
}

TEST(AmphitheatrePlan, HasThePublishedAxes)
{
    EXPECT_NEAR(plan().oval().at(0, building_m).x, 188 / 2.0, 1e-9);
    EXPECT_NEAR(plan().oval().at(1.5707963267948966, building_m).z, 156 / 2.0, 1e-9);
    EXPECT_NEAR(plan().oval().at(0, 0).x, 83 / 2.0, 1e-9);
    EXPECT_NEAR(plan().oval().at(1.5707963267948966, 0).z, 51 / 2.0, 1e-9);
}

TEST(AmphitheatrePlan, HasRoomForFiftyThousandAndNotMuchMore)
{
    EXPECT_GE(seats().size(), 50000u);
    EXPECT_LE(seats().size(), 51000u);
}

TEST(AmphitheatrePlan, SeatsLieOnTheirRowsBetweenArenaAndGallery)
{
    for (const amphitheatre::Seat &seat : seats()) {
        const Row &row = plan().rows()[seat.row];
        const Bearing at = plan().oval().bearing(seat.x, seat.z);
        ASSERT_NEAR(at.out, row.out_m, 1e-9);
        ASSERT_GT(at.out, 0);
        ASSERT_LT(at.out + row.depth_m, plan().walkways().back().from_m + 1e-9);
        ASSERT_EQ(seat.y, row.seat_y_m);
        ASSERT_LT(seat.y, height_m);
    }
}

TEST(AmphitheatrePlan, SeatsOfARowDoNotOverlap)
{
    for (size_t i = 1; i < seats().size(); ++i) {
        const amphitheatre::Seat &a = seats()[i - 1], &b = seats()[i];
        if (a.row != b.row) continue;
        const Row &row = plan().rows()[a.row];
        const double apart = plan().oval().length(b.turn, row.out_m) - plan().oval().length(a.turn, row.out_m);
        const double whole = plan().oval().perimeter(row.out_m);
        const double wide = plan().tiers()[static_cast<size_t>(row.tier)].seat_m;
        ASSERT_GE(apart - whole * std::floor(apart / whole), wide - 1e-6) << "row " << a.row;
    }
}

TEST(AmphitheatrePlan, NoneSitsOnStairsOrInOpenings)
{
    const auto clear = [](const amphitheatre::Seat &seat, double bay, double wide_m) {
        const Row &row = plan().rows()[seat.row];
        const Spot middle = plan().oval().at(plan().turn_of(bay), row.out_m);
        const double apart = std::hypot(seat.x - middle.x, seat.z - middle.z);
        const double seat_m = plan().tiers()[static_cast<size_t>(row.tier)].seat_m;
        ASSERT_GE(apart, (wide_m + seat_m) / 2 - 0.01) << "row " << seat.row << ", bay " << bay;
    };
    std::vector<std::vector<double>> stairs, openings;
    for (size_t row = 0; row < plan().rows().size(); ++row)
        stairs.push_back(plan().stairs_of(row)), openings.push_back(plan().openings_of(row));
    for (const amphitheatre::Seat &seat : seats()) {
        const Tier tier = plan().rows()[seat.row].tier;
        for (const double bay : stairs[seat.row]) clear(seat, bay, plan().tiers()[static_cast<size_t>(tier)].stairs_m);
        for (const double bay : openings[seat.row]) clear(seat, bay, opening_m);
        if (tier == Tier::podium && std::abs(seat.x) < 15) {
            ASSERT_GT(std::abs(seat.x), Plan::box_half_m);
        }
    }
}

TEST(AmphitheatrePlan, HigherTiersLieFartherOut)
{
    for (size_t i = 1; i < plan().rows().size(); ++i) {
        const Row &before = plan().rows()[i - 1], &row = plan().rows()[i];
        EXPECT_GE(row.out_m, before.out_m + before.depth_m - 1e-9);
        EXPECT_GE(row.step_y_m, before.seat_y_m - 1e-9);
        EXPECT_GE(row.tier, before.tier);
    }
}

TEST(AmphitheatrePlan, SittersTurnTowardsTheMiddleOfTheArena)
{
    for (const amphitheatre::Seat &seat : seats()) {
        const Spot spot = plan().oval().at(seat.turn, 0);
        const double away = std::hypot(seat.x, seat.z);
        const double straight = (spot.out_x * seat.x + spot.out_z * seat.z) / away;
        const double turned = -(seat.facing_x * seat.x + seat.facing_z * seat.z) / away;
        ASSERT_NEAR(std::hypot(seat.facing_x, seat.facing_z), 1, 1e-9);
        ASSERT_GE(turned, straight - 1e-9);
    }
}

TEST(AmphitheatrePlan, MorePeopleGetNarrowerSeatsUpToTheOldNumber)
{
    EXPECT_GE(plan_for(most_people).seats().size(), most_people);
    EXPECT_EQ(plan_for(100).seats().size(), seats().size());
    try {
        plan_for(most_people + 1);
        FAIL();
    } catch (const Failure &failure) {
        EXPECT_STREQ(failure.what(), "the amphitheatre holds at most 87000 people, not 87001");
    }
}

TEST(AmphitheatrePeople, SitOnceEachInTheTierOfTheirClass)
{
    const std::vector<Sitter> people = seat_people(plan(), 20000, 1);
    EXPECT_EQ(people.size(), 20000u);
    std::set<size_t> taken;
    std::map<Tier, size_t> counts, room;
    for (const amphitheatre::Seat &seat : seats()) ++room[plan().rows()[seat.row].tier];
    for (const Sitter &sitter : people) {
        EXPECT_TRUE(taken.insert(sitter.seat).second) << sitter.seat;
        EXPECT_EQ(plan().rows()[seats()[sitter.seat].row].tier, sitter.tier);
        EXPECT_LT(sitter.kind, orders_of(sitter.tier).size());
        ++counts[sitter.tier];
    }
    for (const auto &[tier, count] : counts)
        EXPECT_NEAR(static_cast<double>(count) / 20000,
                    static_cast<double>(room[tier]) / static_cast<double>(seats().size()), 1e-4);
}

TEST(AmphitheatrePeople, SitOnTheirSeatsAndNotInTheStone)
{
    for (const Sitter &sitter : seat_people(plan(), 50000, 1)) {
        const amphitheatre::Seat &seat = seats()[sitter.seat];
        const clq_transform &place = sitter.place;
        // Feet on the row below, before the seat's front edge; a little lower or higher for tall and short people.
        ASSERT_NEAR(place.position[1], seat.step_y, 0.05);
        const double before =
            plan().rows()[seat.row].out_m - plan().oval().bearing(place.position[0], place.position[2]).out;
        ASSERT_GT(before, 0.1);
        ASSERT_LT(before, 0.3);
    }
}

TEST(AmphitheatrePeople, LookAtPlacesOfTheirOwn)
{
    std::set<float> gazes;
    for (const Sitter &sitter : seat_people(plan(), 3000, 1)) gazes.insert(sitter.place.orientation_xyzw[1]);
    EXPECT_GT(gazes.size(), 2900u);
}

}  // namespace
