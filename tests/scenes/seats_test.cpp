// Seats lie on their rows, do not overlap and leave gangways free; classes sit apart; heads turn smoothly.
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "samples/scenes/check.h"
#include "samples/scenes/odeon/seating.h"
#include "samples/scenes/scenario/scenario.h"

namespace
{

using namespace scenes;

constexpr double radians = 0.017453292519943295;

const Theatre &odeon()
{
    static const Theatre theatre = *odeon_scenario().theatre;
    return theatre;
}

const std::vector<Seat> &seats()
{
    static const std::vector<Seat> all = seats_of(odeon());
    return all;
}

std::map<size_t, uint32_t> by_class(uint32_t count)
{
    std::map<size_t, uint32_t> counts;
    for (const Sitter &sitter : seat_people(odeon(), seats(), count, 1)) ++counts[sitter.social_class];
    return counts;
}

TEST(Seats, ThereAreSomewhatMoreThanPeople)
{
    EXPECT_GT(seats().size(), 1020u * 105 / 100);
    EXPECT_LT(seats().size(), 1020u * 125 / 100);
}

TEST(Seats, LieOnTheirRowWithinItsSweep)
{
    for (const Seat &seat : seats()) {
        const SeatRow &row = odeon().rows[seat.row];
        EXPECT_NEAR(std::hypot(seat.x, seat.z), row.radius_m, 1e-9);
        EXPECT_EQ(seat.y, row.seat_y_m);
        EXPECT_EQ(seat.step_y, row.step_y_m);
        const double half = odeon().seat_width_m / 2 / row.radius_m / radians;
        EXPECT_GE(seat.angle_deg - half, row.first_deg - 1e-9);
        EXPECT_LE(seat.angle_deg + half, row.last_deg + 1e-9);
    }
}

TEST(Seats, DoNotOverlap)
{
    for (size_t i = 1; i < seats().size(); ++i) {
        const Seat &a = seats()[i - 1], &b = seats()[i];
        if (a.row != b.row) {
            EXPECT_EQ(b.row, a.row + 1);
            continue;
        }
        EXPECT_GE((b.angle_deg - a.angle_deg) * radians * odeon().rows[a.row].radius_m, odeon().seat_width_m - 1e-9);
    }
}

TEST(Seats, KeepOutOfGangways)
{
    for (const Seat &seat : seats())
        for (const Gangway &gangway : odeon().gangways) {
            if (seat.row < gangway.first_row || seat.row > gangway.last_row) continue;
            const double apart = std::abs(seat.angle_deg - gangway.at_deg) * radians * odeon().rows[seat.row].radius_m;
            EXPECT_GE(apart, (odeon().seat_width_m + gangway.width_m) / 2 - 1e-9);
        }
}

TEST(Seats, LookInwardsAndTowardsTheStage)
{
    for (const Seat &seat : seats()) {
        EXPECT_NEAR(std::hypot(seat.facing_x, seat.facing_z), 1, 1e-9);
        const double radius = std::hypot(seat.x, seat.z);
        const double inwards = -(seat.x * seat.facing_x + seat.z * seat.facing_z) / radius;
        EXPECT_GT(inwards, std::cos(6.1 * radians));
        EXPECT_GE(seat.facing_z, -seat.z / radius - 1e-9) << "turned away from the stage";
    }
}

TEST(Seating, EveryClassFillsItsOwnRowsAndNoSeatTwice)
{
    std::set<size_t> taken;
    const std::vector<Sitter> people = seat_people(odeon(), seats(), 1020, 1);
    EXPECT_EQ(people.size(), 1020u);
    for (const Sitter &sitter : people) {
        EXPECT_TRUE(taken.insert(sitter.seat).second);
        EXPECT_EQ(odeon().rows[seats()[sitter.seat].row].social_class, odeon().classes[sitter.social_class].name);
    }
}

TEST(Seating, OtherCountsAreDistributedInProportion)
{
    for (uint32_t count : {0u, 1020u})
        for (const auto &[one, people] : by_class(count)) EXPECT_EQ(people, 340u) << one;
    EXPECT_EQ(by_class(100), (std::map<size_t, uint32_t>{{0, 34}, {1, 33}, {2, 33}}));
    EXPECT_EQ(by_class(1), (std::map<size_t, uint32_t>{{0, 1}}));
}

TEST(Seating, MorePeopleThanSeatsAreRefusedWithTheNumbers)
{
    try {
        seat_people(odeon(), seats(), 1200, 1);
        FAIL();
    } catch (const Failure &failure) {
        EXPECT_EQ(std::string(failure.what()), "an audience of 1200 has 400 decurions, and their rows have 390 seats");
    }
}

TEST(Seating, SizesAreThoseOfWomenAndMen)
{
    for (const Sitter &sitter : seat_people(odeon(), seats(), 1020, 1)) {
        const bool woman = odeon().classes[sitter.social_class].character == "patrician";
        EXPECT_GE(sitter.scale, woman ? 0.93f : 0.97f);
        EXPECT_LE(sitter.scale, woman ? 0.98f : 1.03f);
    }
}

TEST(Seating, TurnsAreBoundedSmoothAndNotAllTheSame)
{
    double least = 0, most = 0;
    for (size_t i = 0; i < seats().size(); ++i) {
        const double turn = facing_turn_deg(odeon(), seats()[i], 1);
        least = std::min(least, turn);
        most = std::max(most, turn);
        if (i == 0 || seats()[i - 1].row != seats()[i].row) continue;
        const double apart = std::hypot(seats()[i].x - seats()[i - 1].x, seats()[i].z - seats()[i - 1].z);
        if (apart > 0.9) continue;  // a gangway between
        EXPECT_LE(std::abs(turn - facing_turn_deg(odeon(), seats()[i - 1], 1)), 0.6 * odeon().facing_noise_deg);
    }
    EXPECT_GE(least, -odeon().facing_noise_deg);
    EXPECT_LE(most, odeon().facing_noise_deg);
    EXPECT_GT(most - least, odeon().facing_noise_deg);
    EXPECT_NE(facing_turn_deg(odeon(), seats()[5], 1), facing_turn_deg(odeon(), seats()[5], 2));
}

}  // namespace
