// Agents that settle at places beside the ground, such as seats, and rise again.

#include "tests/unit/walk/movement_fixture.h"

using namespace claque;
using walk_test::Movement;

// Pieces of an agent that settles beside the ground, and where it is at each tick.
TEST_F(Movement, SettlesExactlyBesideTheGround)
{
    const auto movement = make();
    movement->add(0, walker(1, 3), 0);
    stage::Goal seat = goal(4, -0.05, 1);  // a hand's breadth in the wall
    seat.position[1] = 0.03, seat.heading_rad = 0.4, seat.settles = true;
    movement->go(0, seat, 0);
    double left_s = 0, arrived_s = 0, begins_s = 0, longest_step_m = 0;
    stage::Place before = movement->place(0, 0);
    for (int tick = 1; tick <= 240; ++tick) {
        movement->advance(0.05 * tick, moved_);
        const stage::Place now = movement->place(0, 0.05 * tick);
        longest_step_m = std::max(
            longest_step_m, std::hypot(now.position[0] - before.position[0], now.position[2] - before.position[2]));
        before = now;
        for (const stage::Arrival &one : moved_.arrivals) {
            EXPECT_TRUE(one.reached);
            EXPECT_EQ(arrived_s, 0) << "it is answered once";
            arrived_s = one.time_s;
        }
        for (const stage::Piece &piece : moved_.pieces) {
            if (!piece.track) {
                EXPECT_EQ(left_s, 0) << "it leaves its track once";
                left_s = piece.from_s;
            }
            EXPECT_FALSE(piece.rises);
            begins_s = std::max(begins_s, piece.from_s);
        }
        clear(moved_);
    }
    ASSERT_GT(arrived_s, 2);
    EXPECT_GT(left_s, arrived_s);
    EXPECT_LT(left_s, arrived_s + 1.3);
    EXPECT_EQ(begins_s, left_s) << "no piece comes behind the last one";
    EXPECT_LT(longest_step_m, 0.1) << "it is drawn to its place, and does not jump";
    const stage::Place place = movement->place(0, 12);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(place.position[k], seat.position[k], 0.004) << k;
    EXPECT_NEAR(std::remainder(place.heading_rad - seat.heading_rad, 2 * M_PI), 0, 0.02);
}

TEST_F(Movement, ThatHasSettledIsInNoOthersWay)
{
    // Through the door, in whose middle another one stands; it has settled there or not.
    for (const bool settles : {false, true}) {
        const auto movement = make();
        movement->add(0, walker(7, 3), 0);
        stage::Goal middle = goal(8.1, 3, 1);
        middle.heading_rad = 0, middle.settles = settles, middle.near_m = 0.1f;
        movement->go(0, middle, 0);
        run(*movement, 0, 120);
        movement->add(1, walker(5, 3), 6);
        movement->go(1, goal(12, 3, 2), 6);
        double nearest_m = 9;
        for (int tick = 120; tick < 320; ++tick) {
            run(*movement, tick, tick + 1);
            const double now_s = 0.05 * (tick + 1);
            nearest_m = std::min(nearest_m,
                                 floors::apart(movement->place(0, now_s).position, movement->place(1, now_s).position));
        }
        EXPECT_EQ(nearest_m < 0.15, settles) << nearest_m;
        EXPECT_EQ(nearest_m > 0.25, !settles) << nearest_m;
    }
}

TEST_F(Movement, OfPeopleToPlacesBesideEachOtherEndsThere)
{
    const auto movement = make();
    const auto place_of = [](uint32_t i) { return 4 + 0.6 * i; };
    for (uint32_t i = 0; i < 4; ++i) {
        movement->add(i, walker(1 + 1.8 * i, 1), 0);
        stage::Goal place = goal(place_of(i), 3, i + 1);
        place.near_m = 0.1f;
        movement->go(i, place, 0);
    }
    run(*movement, 0, 400);
    for (uint32_t i = 0; i < 4; ++i) {
        const stage::Place now = movement->place(i, 20);
        EXPECT_LT(std::hypot(now.position[0] - place_of(i), now.position[2] - 3), 0.16) << i;
    }
}

TEST_F(Movement, ThatHasSettledGoesOnFromWhereItWas)
{
    const auto movement = make();
    movement->add(0, walker(1, 3), 0);
    stage::Goal seat = goal(4, -0.05, 1);
    seat.heading_rad = 0, seat.settles = true;
    movement->go(0, seat, 0);
    run(*movement, 0, 240);
    const stage::Place sat = movement->place(0, 12);
    movement->go(0, goal(6, 3, 2), 12.01);
    stage::Place before = sat;
    int rises = 0;
    for (int tick = 241; tick <= 400; ++tick) {
        movement->advance(0.05 * tick, moved_);
        for (const stage::Piece &piece : moved_.pieces) {
            EXPECT_EQ(piece.rises, rises == 0);
            if (piece.rises) EXPECT_NEAR(piece.from_s, 12.01, 1e-9);
            ++rises;
        }
        clear(moved_);
        const stage::Place now = movement->place(0, 0.05 * tick);
        EXPECT_LT(floors::apart(now.position, before.position), 0.12) << "at " << 0.05 * tick;
        before = now;
    }
    EXPECT_GT(rises, 3);
    EXPECT_LT(std::hypot(before.position[0] - 6, before.position[2] - 3), 0.6);
}
