// Byways are for walkers that have a goal there: others go past them, and no crowd pushes them in.
#include "tests/unit/walk/floors.h"

using floors::Floor;
using floors::Held;

namespace
{

// A corridor of 20 by 1.4 m along x, and a room of 6 by 3 m beside its middle, open to it, which is a byway.
Floor corridor_with_a_room(bool is_byway)
{
    Floor floor;
    floor.add(0, 0, 20, 1.4);
    floor.add(7, 1.4, 13, 4.4);
    if (is_byway) floor.byway(7, 1.4, 13, 4.5, 3);
    return floor;
}

// How many ticks of walkers are spent in the room by sixty people who come from both ends and want to get to the other.
int ticks_in_the_room(bool is_byway)
{
    clq_walkers_def def = clq_walkers_def_init();
    const Held held(corridor_with_a_room(is_byway), &def);
    std::vector<clq_walker> people;
    int ticks = 0;
    for (int i = 0; i < 60; ++i) {
        const bool east = i % 2;
        people.push_back(held.add(east ? 19.5 : 0.5, 0.4 + 0.3 * (i % 3)));
        held.go(people.back(), east ? 0.5 : 19.5, 0.7, 0.8f);
        for (int k = 0; k < 12; ++k) {
            held.step();
            for (size_t p = 0; p < people.size(); ++p) {
                const clq_walker_info now = held.info(people[p]);
                if (now.state == CLQ_WALKER_ARRIVED) {
                    EXPECT_EQ(clq_walkers_remove(held.walkers, people[p]), CLQ_OK);
                    people.erase(people.begin() + static_cast<ptrdiff_t>(p--));
                } else ticks += now.position[2] > 1.45;
            }
        }
    }
    return ticks;
}

}  // namespace

TEST(Byways, AreNotEnteredByACrowdThatGoesPast)
{
    EXPECT_GT(ticks_in_the_room(false), 20) << "without a byway this crowd does not spread: the test shows nothing";
    EXPECT_EQ(ticks_in_the_room(true), 0);
}

TEST(Byways, AreEnteredByWalkersThatHaveAGoalThereAndLeftAgain)
{
    const Held held(corridor_with_a_room(true));
    const clq_walker walker = held.add(1, 0.7);
    held.go(walker, 10, 3.5);
    held.step(250);
    EXPECT_EQ(held.info(walker).state, CLQ_WALKER_ARRIVED);
    EXPECT_NEAR(held.info(walker).position[2], 3.5, 0.31);
    held.go(walker, 19, 0.7);
    held.step(280);
    EXPECT_EQ(held.info(walker).state, CLQ_WALKER_ARRIVED);
    EXPECT_NEAR(held.info(walker).position[0], 19, 0.31);
}

// From one byway to another of another group, past a third.
TEST(Byways, OfOtherGroupsAreLeftAndEnteredOnOneWay)
{
    Floor floor;
    floor.add(0, 0, 20, 1.4);
    for (uint32_t i = 0; i < 3; ++i) {
        const double x = 2 + 6 * i;
        floor.add(x, 1.4, x + 3, 4.4);
        floor.byway(x, 1.4, x + 3, 4.5, i);
    }
    const Held held(floor);
    const clq_walker walker = held.add(3.5, 3.5);
    held.go(walker, 15.5, 3.5);
    for (int i = 0; i < 400; ++i) {
        held.step();
        const clq_walker_info now = held.info(walker);
        EXPECT_FALSE(now.position[0] > 7.8 && now.position[0] < 11.2 && now.position[2] > 1.45) << i;
    }
    EXPECT_EQ(held.info(walker).state, CLQ_WALKER_ARRIVED);
    EXPECT_NEAR(held.info(walker).position[0], 15.5, 0.31);
}

// A short way through a byway, and a long way round.
// A byway that two tiles of the ground share has polygons of both.
TEST(Byways, AreLeftThroughTheirOwnPolygons)
{
    floors::Floor floor;
    floor.add(0, 0, 30, 6);
    floor.byway(8, 0, 18, 6, 1);
    const Held held(floor);
    const clq_walker walker = held.add(9, 3);
    held.go(walker, 25, 3);
    held.step(400);
    EXPECT_EQ(held.info(walker).state, CLQ_WALKER_ARRIVED) << held.info(walker).position[0];
}

TEST(Byways, AreNoShortCuts)
{
    Floor floor;
    floor.add(0, 0, 2, 10), floor.add(8, 0, 10, 10), floor.add(2, 8, 8, 10);
    floor.add(2, 1, 8, 2.5);
    floor.byway(2, 0.9, 8, 2.6, 0);
    clq_navigation *made = floor.make().release();
    const double from[3] = {1, 0, 1.7}, to[3] = {9, 0, 1.7}, within[3] = {5, 0, 1.7};
    clq_way way = clq_way_init();
    EXPECT_EQ(clq_navigation_find_way(made, from, to, 0, nullptr, &way), CLQ_OK);
    EXPECT_TRUE(way.complete);
    EXPECT_GT(way.length, 18);
    EXPECT_EQ(clq_navigation_find_way(made, from, within, 0, nullptr, &way), CLQ_OK);
    EXPECT_TRUE(way.complete);
    EXPECT_LT(way.length, 4.1);
    clq_navigation_destroy(made);
}

TEST(Byways, ThatMeanNothingAreRefusedWithTheirNumber)
{
    const auto refused = [](const Floor &floor) {
        const clq_navigation_def def = floor.def();
        clq_navigation *made = nullptr;
        EXPECT_EQ(clq_navigation_create(&def, &made), CLQ_ARGUMENT);
        EXPECT_EQ(made, nullptr);
        return std::string(clq_last_error());
    };
    Floor floor;
    floor.add(0, 0, 10, 10);
    floor.byway(1, 1, 2, 2, 0), floor.byway(3, 3, 4, 4, CLQ_BYWAY_GROUPS);
    EXPECT_NE(refused(floor).find("byway 1 has group 13: 0 to 12 is wanted"), std::string::npos) << clq_last_error();
    floor.byways[1].group = 12;
    for (int i = 0; i < 50; ++i) floor.door(0, 5, 1, 6);
    EXPECT_NE(refused(floor).find("50 doors and byways of group 12: 49 doors are possible"), std::string::npos)
        << clq_last_error();
    floor.doors.clear();
    floor.byways[1].prism.point_count = 2;
    EXPECT_NE(refused(floor).find("byway 1 has 2 points"), std::string::npos) << clq_last_error();
}
