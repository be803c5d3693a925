// Tests of RiMEA's guideline for microscopic evacuation analysis (version 3.0.0, 2016, annex 1), by their numbers, with
// the default walker in ticks of 0.05 s. Test 4 is Queues.WalkAsFastAsPeopleDoAtTheirDensity, test 7 Expression.
// OwnSpeedIsTheAgentsAndNormal; tests 5, 8 and 14 ask for no figure.
#include <algorithm>
#include <functional>
#include <map>

#include <gtest/gtest.h>

#include "samples/halls/crowd.h"

namespace rimea
{
namespace
{

using halls::Crowd;
using halls::Floor;
using halls::Person;

constexpr double tick_s = 0.05, wall_m = 0.2;

// The speed of a person on its way between two lines across x, over the ground.
double speed_between(Crowd &crowd, double from_x, double to_x)
{
    double begun_s = 0;
    for (double time_s = 0; time_s < 100; time_s += tick_s) {
        crowd.step();
        const double x = crowd.people[0].x;
        if (x < from_x) begun_s = time_s;
        else if (x >= to_x) return (to_x - from_x) / (time_s - begun_s);
    }
    return 0;
}

size_t count_in(const Crowd &crowd, double x0, double z0, double x1, double z1)
{
    return static_cast<size_t>(std::count_if(crowd.people.begin(), crowd.people.end(), [&](const Person &one) {
        return one.x > x0 && one.x < x1 && one.z > z0 && one.z < z1;
    }));
}

void fill(Crowd &crowd, size_t count, double x0, double z0, double x1, double z1)
{
    const size_t wanted = crowd.people.size() + count;
    for (int tries = 0; crowd.people.size() < wanted && tries < 1000000; ++tries) {
        const double z = crowd.number(z0, z1), x = crowd.number(x0, x1);
        crowd.add(x, z);
    }
    ASSERT_EQ(crowd.people.size(), wanted);
}

// Steps, and removes each person for whom `is_out` holds. Returns the seconds until the floor is empty; 0: it is not.
double emptied_s(
    Crowd &crowd, double most_s, const std::function<bool(const Person &)> &is_out,
    const std::function<void(double)> &each = [](double) {})
{
    for (double time_s = 0; time_s < most_s; time_s += tick_s) {
        crowd.step();
        for (size_t i = crowd.people.size(); i-- > 0;)
            if (is_out(crowd.people[i])) crowd.remove(i);
        if (crowd.people.empty()) return time_s;
        each(time_s);
    }
    return 0;
}

void note(const char *what, double value) { testing::Test::RecordProperty(what, std::to_string(value)); }

// Rises over ten metres, measured along the slope, by 30 degrees.
Floor flight(double rise_m)
{
    Floor floor;
    floor.add(-4, -1, 0, 1);
    floor.add(0, -1, 8.66, 1, 0, rise_m);
    floor.add(8.66, -1, 13, 1, rise_m, rise_m);
    return floor;
}

double speed_on_stairs(double rise_m)
{
    Crowd crowd(flight(rise_m), {1, tick_s});
    EXPECT_TRUE(crowd.add(-3, 0, 1.34f));
    crowd.go(crowd.people[0], 12.5, 0, 0.2f, rise_m);
    return speed_between(crowd, 1, 8.66);
}

}  // namespace

TEST(Rimea, Test1KeepsItsSpeedInACorridor)
{
    Floor corridor;
    corridor.add(-3, -1, 43, 1);
    Crowd crowd(corridor, {1, tick_s});
    ASSERT_TRUE(crowd.add(-2, 0, 1.33f));
    crowd.go(crowd.people[0], 42.5, 0, 0.2f);
    EXPECT_NEAR(speed_between(crowd, 0, 40), 1.33, 0.01) << "26 to 34 s are demanded: 1.18 to 1.54 m/s";
}

// The speed of stairs is Weidmann's for a person who walks at 1.34 m/s on the level.
TEST(Rimea, Test2And3KeepTheSpeedOfStairsUpAndDown)
{
    EXPECT_NEAR(speed_on_stairs(5), 0.61, 0.03);
    EXPECT_NEAR(speed_on_stairs(-5), 0.694, 0.03);
}

TEST(Rimea, Test6GoesRoundACornerAndThroughNoWall)
{
    Floor corner;
    corner.add(-12, -1, 1, 1);
    corner.add(-1, 1, 1, 12);
    Crowd crowd(corner, {1, tick_s});
    fill(crowd, 20, -11.7, -0.7, -6, 0.7);
    for (const Person &one : crowd.people) crowd.go(one, 0, 11, 0.4f);
    const double margin_m = double(clq_walker_def_init().radius_m) - 0.1;  // less a cell
    const auto each = [&](double time_s) {
        for (const Person &one : crowd.people) {
            const bool in_first = std::fabs(one.z) < 1 - margin_m && one.x < 1 - margin_m;
            const bool in_second = std::fabs(one.x) < 1 - margin_m && one.z > -1 + margin_m;
            ASSERT_TRUE(in_first || in_second) << one.x << " " << one.z << " at " << time_s;
        }
    };
    EXPECT_GT(emptied_s(
                  crowd, 60, [](const Person &one) { return one.z > 10; }, each),
              0);
}

// Twice the time through half the doors. Two doors of each long wall, where the figure of the guideline has them.
TEST(Rimea, Test9NeedsTwiceAsLongThroughHalfTheDoors)
{
    double needed_s[2] = {};
    for (const int walls : {1, 2}) {
        Floor room;
        room.add(-15, -14, 15, 14);
        for (const double z : {-10.0, 10.0})
            for (const auto &[x0, x1] : {std::pair(-15.5, -11.0), {-10.0, 10.0}, {11.0, 15.5}})
                room.wall(x0, z - wall_m / 2, x1, z + wall_m / 2);
        Crowd crowd(room, {1, tick_s});
        fill(crowd, 1000, -13, -8, 13, 8);
        for (const Person &one : crowd.people)
            crowd.go(one, one.x < 0 ? -10.5 : 10.5, walls == 2 && one.z < 0 ? -13.5 : 13.5, 0.5f);
        needed_s[walls - 1] = emptied_s(crowd, 600, [](const Person &one) { return std::fabs(one.z) > 12; });
        ASSERT_GT(needed_s[walls - 1], 0) << "somebody stays";
    }
    note("four_doors_s", needed_s[1]), note("two_doors_s", needed_s[0]);
    EXPECT_NEAR(needed_s[0] / needed_s[1], 2, 0.2);
}

// Twelve rooms at a corridor; the main exit is between rooms 2 and 3, the second one at the corridor's end.
TEST(Rimea, Test10LeavesByTheExitThatIsAssigned)
{
    Floor floor;
    floor.add(0, 0, 20, 11);
    const auto across = [&](double x, double z0, double z1) { floor.wall(x - 0.05, z0, x + 0.05, z1); };
    const auto along = [&](double z, double x0, double x1, std::vector<double> doors) {
        for (const double door : doors) floor.wall(x0, z - 0.05, door - 0.45, z + 0.05), x0 = door + 0.45;
        floor.wall(x0, z - 0.05, x1, z + 0.05);
    };
    for (const double x : {3.0, 6.0, 7.2, 9.0, 12.0, 15.0, 18.0}) across(x, 6, 9.5);
    for (const double x : {3.0, 6.0, 9.0, 12.0, 15.0, 18.0}) across(x, -0.1, 5);
    along(6, -0.1, 6, {1.5, 4.5}), along(6, 7.2, 18, {8.1, 10.5, 13.5, 16.5});
    along(5, -0.1, 18, {1.5, 4.5, 7.5, 10.5, 13.5, 16.5});
    Crowd crowd(floor, {1, tick_s});
    std::map<uint32_t, bool> by_main;
    const auto place = [&](double x, double z, bool main) {
        ASSERT_TRUE(crowd.add(x, z));
        crowd.go(crowd.people.back(), main ? 6.6 : 19.5, main ? 10.7 : 5.5, 0.3f);
        by_main[crowd.people.back().id.index1] = main;
    };
    for (const double z : {1.5, 3.0})
        for (int room = 0; room < 6; ++room) place(1.5 + 3 * room, z, room < 4);
    for (const double z : {7.5, 8.5})
        for (const double x : {1.5, 4.5, 10.5, 13.5, 16.5}) place(x, z, x < 12);
    place(8.1, 8, true);
    ASSERT_EQ(crowd.people.size(), 23u);
    const auto is_out = [&](const Person &one) {
        const bool at_main = one.z > 9 && one.x<8, at_second = one.x> 18.3;
        if (at_main || at_second) EXPECT_EQ(by_main[one.id.index1], at_main) << one.x << " " << one.z;
        return at_main || at_second;
    };
    EXPECT_GT(emptied_s(crowd, 60, is_out), 0);
}

// A queue before the corridor, none before the exit.
TEST(Rimea, Test12QueuesBeforeTheFirstOfTwoNarrowPlaces)
{
    Floor rooms;
    rooms.add(-10, -5, 0, 5);
    rooms.add(0, -0.5, 5, 0.5);
    rooms.add(5, -5, 15, 5);
    rooms.add(15, -0.5, 17, 0.5);
    rooms.cell_m = 0.08f;
    Crowd crowd(rooms, {1, tick_s});
    fill(crowd, 150, -9.7, -4.7, -5, 4.7);
    for (const Person &one : crowd.people) crowd.go(one, 16.7, 0, 0.3f);
    double first = 0, second = 0;
    int samples = 0;
    const auto each = [&](double time_s) {
        if (time_s < 20 || time_s > 60) return;
        first += static_cast<double>(count_in(crowd, -2, -1.5, 0, 1.5)) / 6;
        second += static_cast<double>(count_in(crowd, 13, -1.5, 15, 1.5)) / 6;
        ++samples;
    };
    EXPECT_GT(emptied_s(
                  crowd, 300, [](const Person &one) { return one.x > 16; }, each),
              0);
    note("before_the_corridor", first / samples), note("before_the_exit", second / samples);
    EXPECT_GT(first / samples, 2) << "people a square metre";
    EXPECT_LT(second / samples, 1);
}

// The flow over stairs is smaller than that into the corridor, so the crowd at their foot grows.
TEST(Rimea, Test13QueuesAtTheFootOfStairs)
{
    Floor rooms;
    rooms.add(-5, -4, 0, 4);
    rooms.add(0, -1, 12, 1);
    rooms.add(12, -1, 15, 1, 0, 1.73);
    rooms.add(15, -1, 18, 1, 1.73, 1.73);
    Crowd crowd(rooms, {1, tick_s});
    for (int i = 0; i < 150; ++i) ASSERT_TRUE(crowd.add(-4.75 + 0.45 * (i % 10), -3.7 + 0.5 * (i / 10))) << i;
    for (const Person &one : crowd.people) crowd.go(one, 17.7, 0, 0.3f, 1.73);
    double into_corridor = 0, over_stairs = 0, early = 0, late = 0;
    const auto each = [&](double time_s) {
        const auto passed = [&](double x) {
            return std::count_if(crowd.people.begin(), crowd.people.end(),
                                 [x](const Person &one) { return one.x >= x && one.x - one.moved_x < x; });
        };
        const double foot = static_cast<double>(count_in(crowd, 10, -1, 12, 1)) / 4;
        if (time_s >= 2 && time_s < 10) into_corridor += double(passed(1)) / 8, early += foot * tick_s / 8;
        if (time_s >= 20 && time_s < 40) over_stairs += double(passed(13.5)) / 20, late += foot * tick_s / 20;
    };
    EXPECT_GT(emptied_s(
                  crowd, 300, [](const Person &one) { return one.x > 16.5; }, each),
              0);
    note("into_corridor_people_s", into_corridor), note("over_stairs_people_s", over_stairs);
    note("foot_early", early), note("foot_late", late);
    EXPECT_LT(over_stairs, 0.95 * into_corridor);
    EXPECT_GT(late, 1.5) << "people a square metre";
    EXPECT_GT(late, 2 * early);
}

// Ideally, the way round a corner takes longer than its inner wall and shorter than its outer one, straightened.
TEST(Rimea, Test15NeedsATimeRoundACornerBetweenThoseOfItsWalls)
{
    const auto needed_s = [](Floor floor, double goal_x, double goal_z, bool turns) {
        Crowd crowd(floor, {1, tick_s});
        for (int i = 0; i < 500; ++i) EXPECT_TRUE(crowd.add(-9.65 + 0.48 * (i % 41), -0.3 - 0.45 * (i / 41))) << i;
        for (size_t i = 0; i < crowd.people.size(); ++i) {
            const double across = crowd.people[i].x;  // they spread over the whole target
            crowd.go(crowd.people[i], turns ? goal_x : across, turns ? goal_z - across : goal_z, 1);
        }
        return emptied_s(crowd, 300, [&](const Person &one) { return turns ? one.x > 20 : one.z > goal_z - 2; });
    };
    Floor corner, longer, shorter;
    corner.add(-10, -6, 10, 54), corner.add(10, 34, 24, 54);
    longer.add(-10, -6, 10, 80), shorter.add(-10, -6, 10, 50);
    const double round_s = needed_s(corner, 22, 44, true);
    const double long_s = needed_s(longer, 0, 77.4, false), short_s = needed_s(shorter, 0, 46, false);
    note("corner_s", round_s), note("long_s", long_s), note("short_s", short_s);
    EXPECT_GT(short_s, 0);
    EXPECT_GT(round_s, short_s);
    EXPECT_LT(round_s, 1.1 * long_s) << "ideally it is shorter";
}

}  // namespace rimea
