// Queues: bodies that keep apart at every step, doors and corridors that let through as many people as are measured,
// and lanes of people who meet. All rows hold with the default walker, in ticks of 0.05 s.
#include <algorithm>
#include <cstdlib>
#include <random>

#include "tests/unit/walk/floors.h"

namespace queues
{
namespace
{

constexpr double tick_s = 0.05, pi = 3.14159265358979323846;
const double body_m = double(clq_walker_def_init().radius_m);

// CLAQUE_QUEUE_SEEDS: how many seeds are tried.
unsigned seeds()
{
    const char *wanted = std::getenv("CLAQUE_QUEUE_SEEDS");
    return wanted ? unsigned(std::atoi(wanted)) : 1;
}

struct Person {
    clq_walker id;
    double x, z;
    double moved_x = 0, moved_z = 0;  // in the last tick
};

// People who all walk at speeds of their own, spread as Weidmann (1993) states.
class Crowd
{
public:
    Crowd(const floors::Floor &floor, unsigned seed) : held_(floor, &def()), random_(seed) {}

    // False: there is somebody.
    bool add(double x, double z)
    {
        for (const Person &other : people)
            if (std::hypot(other.x - x, other.z - z) < 2 * body_m + 0.01) return false;
        clq_walker_def def = clq_walker_def_init();
        def.position[0] = x, def.position[2] = z;
        def.speed_m_s = std::clamp(std::normal_distribution<float>(1.34f, 0.26f)(random_), 0.8f, 1.9f);
        Person made{{0, 0}, x, z};
        EXPECT_EQ(clq_walkers_add(held_.walkers, &def, &made.id), CLQ_OK) << clq_last_error();
        people.push_back(made);
        return true;
    }
    double number(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
    void go(const Person &one, double x, double z, float near_m) { held_.go(one.id, x, z, near_m); }
    void remove(size_t i)
    {
        EXPECT_EQ(clq_walkers_remove(held_.walkers, people[i].id), CLQ_OK);
        people[i] = people.back();
        people.pop_back();
    }
    void step()
    {
        held_.step();
        for (Person &one : people) {
            const clq_walker_info info = held_.info(one.id);
            one.moved_x = info.position[0] - one.x, one.moved_z = info.position[2] - one.z;
            one.x = info.position[0], one.z = info.position[2];
        }
        for (size_t i = 0; i < people.size(); ++i)
            for (size_t k = 0; k < i; ++k) {
                const double x = people[i].x - people[k].x, z = people[i].z - people[k].z;
                nearest_m = std::min(nearest_m, x * x + z * z);
            }
    }
    double nearest() const { return std::sqrt(nearest_m); }
    clq_navigation *navigation() const { return held_.navigation; }

    std::vector<Person> people;

private:
    static const clq_walkers_def &def()
    {
        static const clq_walkers_def def = [] {
            clq_walkers_def wanted = clq_walkers_def_init();
            wanted.max_count = 1500, wanted.tick_s = tick_s;
            return wanted;
        }();
        return def;
    }
    floors::Held held_;
    std::mt19937 random_;
    double nearest_m = HUGE_VAL;  // squared
};

struct Passage {
    double flow = 0;  // people a second and metre, while more than 2 a square metre wait within 2 m of the door
    double longest_pause_s = 0, nearest_m = 0;
    size_t left = 0;  // in the hall at the end
};

Passage through_a_door(double width_m, size_t count, unsigned seed)
{
    floors::Floor hall;
    hall.add(-8, -16, 8, 13);
    hall.wall(-8.5, 0, -width_m / 2, 0.3);
    hall.wall(width_m / 2, 0, 8.5, 0.3);
    Crowd crowd(hall, seed);
    while (crowd.people.size() < count) crowd.add(crowd.number(-7.5, 7.5), crowd.number(-15.5, -1));
    for (const Person &one : crowd.people) crowd.go(one, 0, 11.5, 0.5f);
    Passage passage;
    double full_s = 0, last_s = NAN;
    size_t passed = 0;
    const double waiting_m2 = 2 * width_m + pi * 2;
    for (double time_s = 0; time_s < 300 && !crowd.people.empty(); time_s += tick_s) {
        crowd.step();
        size_t waiting = 0, passing = 0;
        for (const Person &one : crowd.people) {
            waiting += one.z < 0 && std::hypot(std::max(0.0, std::fabs(one.x) - width_m / 2), one.z) < 2;
            if (one.z < 0.15 || one.z - one.moved_z >= 0.15) continue;
            ++passing;
            if (!std::isnan(last_s)) passage.longest_pause_s = std::max(passage.longest_pause_s, time_s - last_s);
            last_s = time_s;
        }
        if (static_cast<double>(waiting) > 2 * waiting_m2) full_s += tick_s, passed += passing;
        for (size_t i = crowd.people.size(); i-- > 0;)
            if (crowd.people[i].z > 8) crowd.remove(i);
    }
    passage.flow = static_cast<double>(passed) / full_s / width_m;
    passage.nearest_m = crowd.nearest();
    passage.left = crowd.people.size();
    std::printf(
        "door of %.1f m, %zu people, seed %u: %.2f people a second and metre, pauses up to %.1f s, %.4f m apart\n",
        width_m, count, seed, passage.flow, passage.longest_pause_s, passage.nearest_m);
    return passage;
}

// A corridor that ends where it begins, with its middle 10 m from the centre.
struct Ring {
    double width_m, inner_m = 10 - width_m / 2, outer_m = 10 + width_m / 2;
    double area_m2() const { return pi * (outer_m * outer_m - inner_m * inner_m); }
    floors::Floor floor() const
    {
        floors::Floor made;
        constexpr int parts = 96;
        for (int i = 0; i < parts; ++i) {
            const auto first = static_cast<uint32_t>(made.vertices.size() / 3);
            for (const double angle : {2 * pi * i / parts, 2 * pi * (i + 1) / parts})
                for (const double radius_m : {inner_m, outer_m})
                    for (const double x : {radius_m * std::cos(angle), 0.0, radius_m * std::sin(angle)})
                        made.vertices.push_back(x);
            for (const uint32_t k : {0u, 3u, 1u, 0u, 2u, 3u}) made.triangles.push_back(first + k);
        }
        made.cell_m = 0.08f;
        return made;
    }
};

// People who walk on and on; `ways` 2: every other one the other way round.
struct Round {
    double median_m_s = 0, nearest_m = 0, order = 0, longest_stop_s = 0;
};

Round walked_round(double width_m, double people_per_m2, int ways, unsigned seed)
{
    const Ring ring{width_m};
    Crowd crowd(ring.floor(), seed);
    const auto count = static_cast<size_t>(people_per_m2 * ring.area_m2());
    for (size_t tries = 0; crowd.people.size() < count && tries < 1000000; ++tries) {
        const double angle = crowd.number(-pi, pi), radius_m = crowd.number(ring.inner_m + 0.3, ring.outer_m - 0.3);
        crowd.add(radius_m * std::cos(angle), radius_m * std::sin(angle));
    }
    EXPECT_EQ(crowd.people.size(), count);
    std::vector<double> goals(count), speeds, stopped_s(count);
    const auto way = [&](size_t i) { return ways == 2 && i % 2 ? -1 : 1; };
    const auto send = [&](size_t i) {
        const Person &one = crowd.people[i];
        const double radius_m = std::clamp(std::hypot(one.x, one.z), ring.inner_m + 0.3, ring.outer_m - 0.3);
        goals[i] = std::atan2(one.z, one.x) + 0.6 * way(i);
        crowd.go(one, radius_m * std::cos(goals[i]), radius_m * std::sin(goals[i]), 0.3f);
    };
    for (size_t i = 0; i < count; ++i) send(i);
    Round round;
    for (double time_s = 0; time_s < 60; time_s += tick_s) {
        crowd.step();
        for (size_t i = 0; i < count; ++i) {
            const Person &one = crowd.people[i];
            const double angle = std::atan2(one.z, one.x);
            if (std::remainder(goals[i] - angle, 2 * pi) * way(i) < 0.35) send(i);
            const double made =
                way(i) * (one.moved_z * one.x - one.moved_x * one.z) / std::hypot(one.x, one.z) / tick_s;
            if (time_s > 40) speeds.push_back(made);
            stopped_s[i] = made < 0.05 ? stopped_s[i] + tick_s : 0;
            if (time_s > 10) round.longest_stop_s = std::max(round.longest_stop_s, stopped_s[i]);
        }
    }
    std::nth_element(speeds.begin(), speeds.begin() + static_cast<ptrdiff_t>(speeds.size() / 2), speeds.end());
    round.median_m_s = speeds[speeds.size() / 2];
    round.nearest_m = crowd.nearest();
    // Order of lanes (Rex and Loewen 2007): in parts half a metre wide and a sixteenth of the round long, the square of
    // the difference of the two kinds of people over that of their sum.
    std::vector<std::array<double, 2>> parts(16 * 20);
    for (size_t i = 0; i < count; ++i) {
        const Person &one = crowd.people[i];
        const auto lane = static_cast<size_t>((std::hypot(one.x, one.z) - ring.inner_m) / 0.5);
        const auto sector = static_cast<size_t>((std::atan2(one.z, one.x) + pi) / (2 * pi) * 16) % 16;
        parts[lane * 16 + sector][way(i) < 0] += 1;
    }
    for (const auto &part : parts)
        if (part[0] + part[1] > 0)
            round.order += (part[0] - part[1]) * (part[0] - part[1]) / (part[0] + part[1]) / double(count);
    std::printf(
        "corridor of %.0f m, %.1f people a square metre, %d way(s), seed %u: median %.2f m/s, order %.2f, stops up "
        "to %.1f s, %.4f m apart\n",
        width_m, people_per_m2, ways, seed, round.median_m_s, round.order, round.longest_stop_s, round.nearest_m);
    return round;
}

// Speed at a density (Weidmann, Transporttechnik der Fussgaenger, 1993).
double weidmann_m_s(double people_per_m2) { return 1.34 * (1 - std::exp(-1.913 * (1 / people_per_m2 - 1 / 5.4))); }

}  // namespace

TEST(Queues, PassDoorsAsMeasuredAndNobodyTouchesAnother)
{
    // Narrow doors: fewer at least, and longer pauses.
    const struct {
        double width_m;
        size_t people;
        double least, most, longest_pause_s;
    } doors[] = {{0.8, 80, 0.9, 1.7, 10},
                 {1.0, 150, 0.9, 1.7, 10},
                 {1.2, 150, 1.1, 1.9, 3},
                 {2.0, 150, 1.1, 1.9, 3},
                 {4.0, 300, 1.1, 1.9, 3}};
    for (unsigned seed = 1; seed <= seeds(); ++seed) {
        double lowest = HUGE_VAL, highest = 0;
        for (const auto &door : doors) {
            const Passage passage = through_a_door(door.width_m, door.people, seed);
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

TEST(Queues, WalkAsFastAsPeopleDoAtTheirDensity)
{
    for (unsigned seed = 1; seed <= seeds(); ++seed)
        for (const double people_per_m2 : {1.0, 2.0, 3.0}) {
            const Round round = walked_round(4, people_per_m2, 1, seed);
            // At 1 a square metre they are slower than people.
            EXPECT_NEAR(round.median_m_s, weidmann_m_s(people_per_m2), people_per_m2 < 2 ? 0.25 : 0.15)
                << people_per_m2;
            EXPECT_GE(round.nearest_m, 2 * body_m - 0.001) << people_per_m2;
        }
}

TEST(Queues, FormLanesWherePeopleMeet)
{
    for (unsigned seed = 1; seed <= seeds(); ++seed)
        for (const double people_per_m2 : {1.0, 1.5}) {
            const Round round = walked_round(5, people_per_m2, 2, seed);
            EXPECT_GT(round.order, 0.8) << people_per_m2;
            EXPECT_GE(round.median_m_s, 0.7 * weidmann_m_s(people_per_m2)) << people_per_m2;
            EXPECT_GE(round.nearest_m, 2 * body_m - 0.001) << people_per_m2;
        }
}

// Nobody trembles: they came, and stand.
TEST(Queues, StandStillBehindAClosedDoor)
{
    floors::Floor hall;
    hall.outlines.reserve(64);
    hall.add(-8, -16, 8, 13);
    hall.wall(-8.5, 0, -1, 0.3);
    hall.wall(1, 0, 8.5, 0.3);
    hall.door(-1, 0, 1, 0.3);
    Crowd crowd(hall, 1);
    EXPECT_EQ(clq_navigation_set_door(crowd.navigation(), 0, false), CLQ_OK);
    while (crowd.people.size() < 100) crowd.add(crowd.number(-7.5, 7.5), crowd.number(-15.5, -1));
    for (const Person &one : crowd.people) crowd.go(one, 0, 11.5, 0.5f);
    for (double time_s = 0; time_s < 40; time_s += tick_s) crowd.step();
    const std::vector<Person> before = crowd.people;
    std::vector<bool> moved(before.size());
    size_t at_the_door = 0;
    for (double time_s = 0; time_s < 2; time_s += tick_s) {
        crowd.step();
        for (size_t i = 0; i < before.size(); ++i)
            if (std::hypot(crowd.people[i].x - before[i].x, crowd.people[i].z - before[i].z) > 0.02) moved[i] = true;
    }
    for (const Person &one : before) at_the_door += std::hypot(one.x, one.z) < 5;
    EXPECT_GT(at_the_door, 90u);
    EXPECT_LE(std::count(moved.begin(), moved.end(), true), 3);
    EXPECT_GE(crowd.nearest(), 2 * body_m - 0.001);
}

}  // namespace queues
