// Queues: bodies that keep apart at every step, doors and corridors that let through as many people as are measured,
// and lanes of people who meet. All rows hold with the default walker.
#include <algorithm>
#include <cstdlib>
#include <tuple>

#include <gtest/gtest.h>

#include "samples/halls/door.h"
#include "samples/halls/ring.h"

namespace queues
{
namespace
{

const double body_m = double(clq_walker_def_init().radius_m);
const double turned_m = 0.85 * body_m;  // of walkers that turn their shoulders where oncoming ones hold them up

// CLAQUE_QUEUE_SEEDS: how many seeds are tried; CLAQUE_QUEUE_TICK_S: a tick other than 0.05 s.
std::vector<halls::Trial> trials()
{
    const char *seeds = std::getenv("CLAQUE_QUEUE_SEEDS"), *tick_s = std::getenv("CLAQUE_QUEUE_TICK_S");
    std::vector<halls::Trial> all;
    for (unsigned seed = 1; seed <= (seeds ? unsigned(std::atoi(seeds)) : 1); ++seed) {
        all.push_back({seed});
        if (tick_s) all.back().tick_s = std::atof(tick_s);
    }
    return all;
}

}  // namespace

TEST(Queues, PassDoorsAsMeasuredAndNobodyTouchesAnother)
{
    for (const halls::Trial &trial : trials()) {
        double lowest = HUGE_VAL, highest = 0;
        for (const halls::Door &door : halls::doors) {
            const halls::Passage passage = halls::through_a_door(door.width_m, door.people, trial);
            EXPECT_EQ(passage.left, 0u) << door.width_m;
            EXPECT_GE(passage.nearest_m, 2 * body_m - 0.001) << door.width_m;
            EXPECT_GE(passage.flow, door.least) << door.width_m;
            EXPECT_LE(passage.flow, door.most) << door.width_m;
            EXPECT_LE(passage.longest_pause_s, door.longest_pause_s) << door.width_m;
            if (door.width_m < 1.2) continue;
            lowest = std::min(lowest, passage.flow), highest = std::max(highest, passage.flow);
        }
        // Twice as wide a door lets twice as many through.
        EXPECT_LE(highest, 1.15 * (lowest + highest) / 2);
        EXPECT_GE(lowest, 0.85 * (lowest + highest) / 2);
    }
}

// The preferred speeds of samples/scenarios/evacuation.
TEST(Queues, PassDoorsAsMeasuredAtHighPreferredSpeeds)
{
    for (halls::Trial trial : trials()) {
        trial.least_m_s = 1.3, trial.most_m_s = 1.9;
        for (const halls::Door &door : halls::doors) {
            const halls::Passage passage = halls::through_a_door(door.width_m, door.people, trial);
            EXPECT_EQ(passage.left, 0u) << door.width_m;
            EXPECT_GE(passage.flow, door.least) << door.width_m;
            EXPECT_LE(passage.flow, door.width_m < 4 ? door.most : 1.94) << door.width_m;  // 1.9 is demanded
        }
    }
}

TEST(Queues, WalkAsFastAsPeopleDoAtTheirDensity)
{
    for (const halls::Trial &trial : trials())
        for (const double people_per_m2 : {1.0, 2.0, 3.0}) {
            const halls::Round round = halls::walked_round(4, people_per_m2, 1, trial);
            EXPECT_NEAR(round.median_m_s, halls::weidmann_m_s(people_per_m2), 0.15) << people_per_m2;
            EXPECT_GE(round.nearest_m, 2 * body_m - 0.001) << people_per_m2;
        }
}

TEST(Queues, FormLanesWherePeopleMeet)
{
    for (const halls::Trial &trial : trials())
        for (const double people_per_m2 : {1.0, 1.5}) {
            const halls::Round round = halls::walked_round(5, people_per_m2, 2, trial);
            EXPECT_GT(round.order, 0.8) << people_per_m2;
            EXPECT_GE(round.median_m_s, 0.7 * halls::weidmann_m_s(people_per_m2)) << people_per_m2;
            EXPECT_GE(round.nearest_m, 2 * turned_m - 0.001) << people_per_m2;
            EXPECT_LE(round.nearest_m, 2 * turned_m + 0.001) << people_per_m2;
            EXPECT_LE(round.longest_stop_s, 10) << people_per_m2;  // 5 s are wanted
        }
}

// One goes first, and the others go back.
TEST(Queues, PassAnOpeningFromBothSides)
{
    for (const halls::Trial &trial : trials())
        for (const auto &[width_m, count, most_s] :
             {std::tuple{0.8, 12u, 90.0}, {1.0, 12u, 75.0}, {1.0, 30u, 120.0}, {1.2, 30u, 100.0}, {2.0, 30u, 60.0}}) {
            const halls::Meeting meeting = halls::meet_at_a_door(width_m, count, trial);
            EXPECT_EQ(meeting.left, 0u) << width_m << " m, " << count;
            EXPECT_LE(meeting.last_s, most_s) << width_m << " m, " << count;
            EXPECT_GE(meeting.nearest_m, 2 * turned_m - 0.001) << width_m << " m, " << count;
        }
}

// Two crowds of 60 jam on both sides of the opening, too, where no walls are near.
TEST(Queues, GoOnWhereTwoCrowdsJamInTheOpen)
{
    const halls::Meeting meeting = halls::meet_at_a_door(2, 60, {7});
    EXPECT_EQ(meeting.left, 0u);
    EXPECT_LE(meeting.last_s, 150);
}

// Nobody trembles: they came, and stand.
TEST(Queues, StandStillBehindAClosedDoor)
{
    halls::Floor hall = halls::hall_with_opening(2);
    hall.door(-1, 0, 1, 0.3);
    const halls::Trial trial = trials()[0];
    halls::Crowd crowd(hall, trial);
    EXPECT_EQ(clq_navigation_set_door(crowd.navigation(), 0, false), CLQ_OK);
    while (crowd.people.size() < 100) {
        const double z = crowd.number(-15.5, -1), x = crowd.number(-7.5, 7.5);
        crowd.add(x, z);
    }
    for (const halls::Person &one : crowd.people) crowd.go(one, 0, 11.5, 0.5f);
    for (double time_s = 0; time_s < 40; time_s += trial.tick_s) crowd.step();
    const std::vector<halls::Person> before = crowd.people;
    std::vector<bool> moved(before.size());
    size_t at_the_door = 0;
    for (double time_s = 0; time_s < 2; time_s += trial.tick_s) {
        crowd.step();
        for (size_t i = 0; i < before.size(); ++i)
            if (std::hypot(crowd.people[i].x - before[i].x, crowd.people[i].z - before[i].z) > 0.02) moved[i] = true;
    }
    for (const halls::Person &one : before) at_the_door += std::hypot(one.x, one.z) < 5;
    EXPECT_GT(at_the_door, 90u);
    EXPECT_LE(std::count(moved.begin(), moved.end(), true), 3);
    EXPECT_GE(crowd.nearest_m(), 2 * turned_m - 0.001);
}

}  // namespace queues
