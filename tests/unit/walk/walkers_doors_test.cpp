// Doors: walkers that come wait, those that stand in one walk out, and none jumps.
#include <atomic>
#include <thread>

#include "tests/unit/walk/floors.h"

using floors::Held;

TEST(WalkersAtADoor, StopBeforeItAndGoOnWhenItOpens)
{
    const Held held(floors::two_rooms(true));
    const clq_walker walker = held.add(1, 3);
    held.go(walker, 15, 3);
    held.step(40);
    ASSERT_EQ(clq_navigation_set_door(held.navigation, 0, false), CLQ_OK);
    held.step(200);
    EXPECT_EQ(held.info(walker).state, CLQ_WALKER_BLOCKED);
    EXPECT_LT(held.info(walker).position[0], 8.0);
    EXPECT_GT(held.info(walker).position[0], 7.0);
    ASSERT_EQ(clq_navigation_set_door(held.navigation, 0, true), CLQ_OK);
    held.step(250);
    EXPECT_EQ(held.info(walker).state, CLQ_WALKER_ARRIVED);
    EXPECT_NEAR(held.info(walker).position[0], 15, 0.31);
}

// A door that two tiles of the ground share has polygons of both.
TEST(WalkersAtADoor, WalkOutOfOneThatIsDeep)
{
    floors::Floor floor;
    floor.add(0, 0, 30, 6);
    floor.door(9, 0, 17, 6);
    const Held held(floor);
    const clq_walker walker = held.add(5, 3);
    held.go(walker, 25, 3);
    while (held.info(walker).position[0] < 10) held.step();
    ASSERT_EQ(clq_navigation_set_door(held.navigation, 0, false), CLQ_OK);
    held.step(400);
    EXPECT_EQ(held.info(walker).state, CLQ_WALKER_ARRIVED) << held.info(walker).position[0];
}

TEST(WalkersAtADoor, WalkOutOfOneThatCloses)
{
    const Held held(floors::two_rooms(true));
    const clq_walker walker = held.add(1, 3);
    held.go(walker, 15, 3);
    while (held.info(walker).position[0] < 8.05) held.step();
    ASSERT_EQ(clq_navigation_set_door(held.navigation, 0, false), CLQ_OK);
    clq_walker_info before = held.info(walker);
    for (int i = 0; i < 250; ++i) {
        held.step();
        const clq_walker_info now = held.info(walker);
        ASSERT_LT(floors::apart(now.position, before.position), 0.05 * 1.5) << i;  // no jump
        before = now;
    }
    EXPECT_EQ(before.state, CLQ_WALKER_ARRIVED);
    // The way back is barred.
    held.go(walker, 1, 3);
    held.step(250);
    EXPECT_EQ(held.info(walker).state, CLQ_WALKER_BLOCKED);
    EXPECT_GT(held.info(walker).position[0], 8.2);
}

TEST(WalkersAtADoor, OfACrowdAllWaitAndNoneIsInTheDoor)
{
    const Held held(floors::two_rooms(true));
    std::vector<clq_walker> people;
    for (int i = 0; i < 20; ++i) {
        people.push_back(held.add(1 + 0.6 * (i % 5), 1 + 0.9 * (i / 5)));
        held.go(people.back(), 14, 1 + 0.9 * (i / 5), 1.5f);
    }
    held.step(110);
    ASSERT_EQ(clq_navigation_set_door(held.navigation, 0, false), CLQ_OK);
    held.step(400);
    int before = 0, behind = 0;
    for (const clq_walker walker : people) {
        const double x = held.info(walker).position[0];
        before += x<7.95, behind += x> 8.25;
    }
    EXPECT_EQ(before + behind, 20);
    EXPECT_GT(before, 3);
    EXPECT_GT(behind, 0);
    ASSERT_EQ(clq_navigation_set_door(held.navigation, 0, true), CLQ_OK);
    held.step(900);
    for (const clq_walker walker : people) EXPECT_GT(held.info(walker).position[0], 8.25);
}

// Calls on one navigation and its walkers wait for each other.
TEST(WalkersAtADoor, MayBeSteppedWhileOtherThreadsOpenItAndAskForWays)
{
    const Held held(floors::two_rooms(true));
    const clq_walker walker = held.add(1, 3);
    std::atomic<bool> stop{false};
    std::atomic<uint32_t> asked{0};
    std::thread doors([&] {
        for (bool open = false; !stop; open = !open)
            EXPECT_EQ(clq_navigation_set_door(held.navigation, 0, open), CLQ_OK) << clq_last_error();
    });
    std::thread ways([&] {
        const double from[3] = {1, 0, 3};
        while (!stop) {
            bool open = false, found = false;
            double nearest[3];
            EXPECT_EQ(clq_navigation_get_door(held.navigation, 0, &open), CLQ_OK) << clq_last_error();
            EXPECT_EQ(clq_navigation_find_nearest(held.navigation, from, 1, nearest, &found), CLQ_OK)
                << clq_last_error();
            ++asked;
        }
    });
    for (int round = 0; round < 40 || asked < 40; ++round) {
        held.go(walker, round % 2 ? 1 : 15, 3);
        held.step(5);
    }
    stop = true;
    doors.join(), ways.join();
}
