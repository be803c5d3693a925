// Walkers arrive where they are sent, give way to each other, and do the same again.
#include <thread>

#include "tests/unit/walk/floors.h"

using floors::Floor;
using floors::Held;

namespace
{

// Two streams of people that cross each other, and some in between.
std::vector<clq_walker> crossing(const Held &held)
{
    std::vector<clq_walker> people;
    for (int i = 0; i < 20; ++i) {
        const double row = 2 + 1.0 * (i % 10), column = 1 + 0.9 * (i / 10);
        people.push_back(held.add(column, row));
        held.go(people.back(), 16 + column, row);  // the one ahead goes farther
        people.push_back(held.add(row + 3, 0.8 + column));
        held.go(people.back(), row + 3, 10 + column);
    }
    return people;
}

Floor square()
{
    Floor floor;
    floor.add(0, 0, 19, 14);
    floor.wall(9, 6.5, 9.8, 7.3);
    return floor;
}

std::vector<uint64_t> hashes_of_a_run()
{
    const Held held(square());
    crossing(held);
    std::vector<uint64_t> hashes;
    for (int i = 0; i < 200; ++i) held.step(), hashes.push_back(held.hash());
    return hashes;
}

}  // namespace

TEST(WalkersOfAStage, ArriveWhereTheyAreSent)
{
    const Held held(floors::two_rooms(false));
    const clq_walker walker = held.add(1, 1);
    EXPECT_EQ(held.info(walker).state, CLQ_WALKER_STANDS);
    held.go(walker, 15, 5);
    EXPECT_EQ(held.info(walker).state, CLQ_WALKER_WAITS);
    held.step();
    EXPECT_EQ(held.info(walker).state, CLQ_WALKER_WALKS);
    double fastest = 0;
    int ticks = 0;
    for (; ticks < 400 && held.info(walker).state == CLQ_WALKER_WALKS; ++ticks) {
        held.step();
        const clq_walker_info now = held.info(walker);
        fastest = std::max(fastest, double(std::hypot(now.velocity_m_s[0], now.velocity_m_s[2])));
        // The middle of a person stays its radius away from the wall.
        const bool in_wall = now.position[0] > 7.85 && now.position[0] < 8.35;
        if (in_wall) {
            EXPECT_LT(std::fabs(now.position[2] - 3), 0.45);
        }
    }
    const double goal[3] = {15, 0, 5};
    EXPECT_EQ(held.info(walker).state, CLQ_WALKER_ARRIVED);
    EXPECT_LT(floors::apart(held.info(walker).position, goal), 0.31);
    EXPECT_NEAR(fastest, 1.34, 0.05);
    // 14.6 m at 1.34 m/s take 10.9 s.
    EXPECT_NEAR(0.05 * ticks, 11.3, 1.2);
    held.step(40);
    EXPECT_LT(floors::apart(held.info(walker).position, goal), 0.5);
}

TEST(WalkersOfAStage, ArriveWhateverTheirRadius)
{
    floors::Floor hall;
    hall.add(0, 0, 30, 12);
    clq_walkers_def def = clq_walkers_def_init();
    def.max_radius_m = 2;
    const Held held(hall, &def);
    const clq_walker wide = held.add(4, 6, nullptr, 1.5f), other = held.add(26, 6.5, nullptr, 1.5f);
    held.go(wide, 26, 6), held.go(other, 4, 6);
    double nearest_m = HUGE_VAL;
    for (int i = 0; i < 800; ++i) {
        held.step();
        nearest_m = std::min(nearest_m, floors::apart(held.info(wide).position, held.info(other).position));
    }
    for (const clq_walker one : {wide, other}) EXPECT_EQ(held.info(one).state, CLQ_WALKER_ARRIVED);
    EXPECT_GE(nearest_m, 2.999);
}

TEST(WalkersOfAStage, KeepApartAndAllArrive)
{
    const Held held(square());
    const std::vector<clq_walker> people = crossing(held);
    double nearest = 1e9;
    for (int i = 0; i < 900; ++i) {
        held.step();
        for (size_t a = 0; a < people.size(); ++a)
            for (size_t b = 0; b < a; ++b)
                nearest =
                    std::min(nearest, floors::apart(held.info(people[a]).position, held.info(people[b]).position));
    }
    std::printf("walkers: the nearest two were %.3f m apart; their bodies are 0.44 m wide\n", nearest);
    EXPECT_GT(nearest, 0.30);
    int arrived = 0;
    for (const clq_walker walker : people) arrived += held.info(walker).state == CLQ_WALKER_ARRIVED;
    EXPECT_EQ(arrived, 40);
}

TEST(WalkersOfAStage, StayOnTheGround)
{
    const Held held(square());
    const std::vector<clq_walker> people = crossing(held);
    for (int i = 0; i < 300; ++i) {
        held.step();
        for (const clq_walker walker : people) {
            const clq_walker_info now = held.info(walker);
            double place[3];
            bool found = false;
            ASSERT_EQ(clq_navigation_find_nearest(held.navigation, now.position, 0.3, place, &found), CLQ_OK);
            ASSERT_TRUE(found) << i;
            ASSERT_LT(floors::apart(now.position, place), 0.02) << i;
        }
    }
}

TEST(WalkersOfAStage, DoTheSameAgainOnAnyThread)
{
    const std::vector<uint64_t> first = hashes_of_a_run();
    std::vector<uint64_t> second, third;
    std::thread a([&] { second = hashes_of_a_run(); }), b([&] { third = hashes_of_a_run(); });
    a.join(), b.join();
    EXPECT_EQ(first, second);
    EXPECT_EQ(first, third);
    EXPECT_NE(first[100], first[101]);
}

TEST(WalkersOfAStage, FindAtMostSoManyWaysInATickAndNoneWaitsForEver)
{
    clq_walkers_def def = clq_walkers_def_init();
    def.plans = 3;
    const Held held(square(), &def);
    const std::vector<clq_walker> people = crossing(held);
    for (uint32_t tick = 1; tick <= 14; ++tick) {
        held.step();
        clq_walkers_info info = clq_walkers_info_init();
        ASSERT_EQ(clq_walkers_get_info(held.walkers, &info), CLQ_OK);
        ASSERT_EQ(info.plans, 3 * tick);
        // The same three are sent again and again.
        for (size_t k = 0; k < 3; ++k) held.go(people[k], 18, 12);
    }
    for (size_t k = 3; k < people.size(); ++k) EXPECT_NE(held.info(people[k]).state, CLQ_WALKER_WAITS) << k;
}

TEST(WalkersOfAStage, StopAndAreRemoved)
{
    const Held held(floors::two_rooms(false));
    const clq_walker walker = held.add(1, 3);
    held.go(walker, 15, 3);
    held.step(40);
    ASSERT_EQ(clq_walker_stop(held.walkers, walker), CLQ_OK);
    held.step(20);
    const clq_walker_info stopped = held.info(walker);
    EXPECT_EQ(stopped.state, CLQ_WALKER_STANDS);
    held.step(20);
    EXPECT_LT(floors::apart(stopped.position, held.info(walker).position), 0.01);
    ASSERT_EQ(clq_walkers_remove(held.walkers, walker), CLQ_OK);
    EXPECT_EQ(clq_walkers_remove(held.walkers, walker), CLQ_STALE_ID);
    const clq_walker next = held.add(2, 3);
    EXPECT_EQ(next.index1, walker.index1);
    EXPECT_NE(next.generation, walker.generation);
    EXPECT_EQ(clq_walker_stop(held.walkers, walker), CLQ_STALE_ID);
    EXPECT_EQ(clq_walker_stop(held.walkers, {0, 0}), CLQ_ARGUMENT);
    EXPECT_EQ(clq_walker_stop(held.walkers, {501, 1}), CLQ_ARGUMENT);
}

TEST(WalkersOfAStage, AreRefusedForNumbersThatMeanNothing)
{
    const Held held(floors::two_rooms(false));
    clq_walker_def def = clq_walker_def_init();
    clq_walker out = {7, 7};
    def.position[0] = 1, def.position[2] = 1;
    for (float clq_walker_def::*member : {&clq_walker_def::radius_m, &clq_walker_def::speed_m_s,
                                          &clq_walker_def::acceleration_m_s2, &clq_walker_def::scale})
        for (const float bad : {-1.0f, 0.0f, NAN, INFINITY, 1e30f}) {
            clq_walker_def wrong = def;
            wrong.*member = bad;
            EXPECT_EQ(clq_walkers_add(held.walkers, &wrong, &out), CLQ_ARGUMENT);
        }
    def.position[0] = 100;
    EXPECT_EQ(clq_walkers_add(held.walkers, &def, &out), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("no ground within 2 m of 100, 0, 1"), std::string::npos);
    def.position[0] = NAN;
    EXPECT_EQ(clq_walkers_add(held.walkers, &def, &out), CLQ_ARGUMENT);
    EXPECT_EQ(out.index1, 7u);
    const clq_walker walker = held.add(1, 1);
    const double goal[3] = {2, 0, 2}, lost[3] = {NAN, 0, 0}, far[3] = {2, 50, 2};
    EXPECT_EQ(clq_walker_go(held.walkers, walker, lost, 1, 1), CLQ_ARGUMENT);
    EXPECT_EQ(clq_walker_go(held.walkers, walker, far, 1, 1), CLQ_ARGUMENT);
    EXPECT_EQ(clq_walker_go(held.walkers, walker, goal, 0, 1), CLQ_ARGUMENT);
    EXPECT_EQ(clq_walker_go(held.walkers, walker, goal, 1, NAN), CLQ_ARGUMENT);
    EXPECT_EQ(held.info(walker).state, CLQ_WALKER_STANDS);
    clq_walkers *made = nullptr;
    clq_walkers_def few = clq_walkers_def_init();
    few.tick_s = 0.01, few.piece_ticks = 2;
    EXPECT_EQ(clq_walkers_create(held.navigation, &few, &made), CLQ_ARGUMENT);
    few = clq_walkers_def_init(), few.max_count = 0;
    EXPECT_EQ(clq_walkers_create(held.navigation, &few, &made), CLQ_ARGUMENT);
    few.max_count = 1;
    ASSERT_EQ(clq_walkers_create(held.navigation, &few, &made), CLQ_OK);
    def.position[0] = 3;
    EXPECT_EQ(clq_walkers_add(made, &def, &out), CLQ_OK);
    EXPECT_EQ(clq_walkers_add(made, &def, &out), CLQ_LIMIT);
    clq_walkers_destroy(made);
}
