// The evening of samples/scenarios/odeon-evening.toml: people find seats of their class that are theirs alone, laugh
// and applaud with their neighbours and stop, and all leave.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/staged/staged_world.h"

namespace staged_test
{
namespace
{

using namespace scenes;
using Point3 = std::array<double, 3>;

Scenario evening() { return load_scenario(std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/odeon-evening.toml"); }

Scenario evening(uint32_t of_each_class, double per_minute)
{
    Scenario scenario = evening();
    for (ScenarioAgents &agents : scenario.stage->agents) agents.count = of_each_class, agents.per_minute = per_minute;
    return scenario;
}

double apart(const Point3 &a, const Point3 &b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

// One evening for all tests, in steps of half a second; at 395 s, between two acts, a person with neighbours hears a
// joke of its own.
class Evening : public testing::Test
{
protected:
    static constexpr double step_s = 0.5, seated_s = 240, joke_s = 395, end_s = 600;
    static constexpr uint32_t of_each_class = 180;  // as the scenario has it

    struct Seen {
        std::string state;  // "": it is not here
        Point3 at;
    };
    using Moment = std::vector<Seen>;

    static const std::vector<Moment> &moments()
    {
        static const std::vector<Moment> all = watch();
        return all;
    }
    static const Moment &at(double time_s) { return moments()[static_cast<size_t>(time_s / step_s)]; }
    static size_t count() { return at(0).size(); }
    static size_t count_in(double time_s, const std::set<std::string> &states)
    {
        const Moment &now = at(time_s);
        const auto is_in = [&](const Seen &one) { return states.count(one.state) > 0; };
        return static_cast<size_t>(std::count_if(now.begin(), now.end(), is_in));
    }
    static size_t the_joker;  // who hears a joke of its own

    static const std::set<std::string> on_seats;

private:
    static std::vector<Moment> watch()
    {
        World world(evening(), 1, false);
        const auto people = static_cast<uint32_t>(world.run().people().all().size());
        std::vector<Moment> all;
        for (double time_s = 0; time_s <= end_s; time_s += step_s) {
            world.run().decide(time_s);
            Moment &now = all.emplace_back(people);
            for (uint32_t i = 0; i < people; ++i) {
                if (!world.run().is_here(i)) continue;
                clq_agent_info info = clq_agent_info_init();
                check(clq_stage_get_agent(world.run().handle(), world.run().agent_of(i), &info));
                now[i] = {info.state, world.run().place_of(i)};
            }
            if (time_s == joke_s) tell(world.run(), now);
        }
        EXPECT_EQ(world.run().info().runaways, 0u);
        return all;
    }
    // To the person with most neighbours.
    static void tell(staged::Run &run, const Moment &now)
    {
        size_t most = 0;
        for (size_t i = 0; i < now.size(); ++i) {
            if (now[i].state != "attends") continue;
            const auto is_near = [&](const Seen &other) {
                return other.state == "attends" && apart(other.at, now[i].at) < 1.5;
            };
            const auto near = static_cast<size_t>(std::count_if(now.begin(), now.end(), is_near));
            if (near > most) most = near, the_joker = i;
        }
        run.send(static_cast<uint32_t>(the_joker), "joke", now[the_joker].at.data(), 1);
    }
};

size_t Evening::the_joker = 0;
const std::set<std::string> Evening::on_seats = {"rests",  "talks", "listens", "attends", "gets_it",
                                                 "laughs", "claps", "cheers",  "sits"};

TEST_F(Evening, SeatsEachPersonInARowOfItsClassAndNoTwoOnOneSeat)
{
    const Moment &now = at(seated_s);
    ASSERT_EQ(count(), 3 * of_each_class);
    // Patricians, decurions, plebeians; feet stand up to 0.3 m before the first row.
    const double least_m[] = {15.4, 6.6, 19.3}, most_m[] = {19.6, 14.0, 23.0};
    const auto class_of = [](size_t person) { return std::array<int, 3>{2, 0, 1}[person / of_each_class]; };
    for (size_t i = 0; i < count(); ++i) {
        EXPECT_TRUE(on_seats.count(now[i].state)) << "person " << i << " is in " << now[i].state;
        const double radius_m = std::hypot(now[i].at[0], now[i].at[2]);
        EXPECT_GT(radius_m, least_m[class_of(i)]) << "person " << i;
        EXPECT_LT(radius_m, most_m[class_of(i)]) << "person " << i;
        for (size_t k = 0; k < i; ++k) EXPECT_GT(apart(now[i].at, now[k].at), 0.6) << i << " and " << k;
    }
    // All the time: seats do not change their owners.
    for (double time_s = seated_s; time_s < 419; time_s += 5)
        for (size_t i = 0; i < count(); ++i) EXPECT_EQ(apart(at(time_s)[i].at, now[i].at), 0) << i << " at " << time_s;
}

TEST_F(Evening, HasLaughsThatSpreadToNeighboursAndEnd)
{
    std::map<size_t, double> began;
    for (double time_s = joke_s; time_s < joke_s + 3; time_s += step_s)
        for (size_t i = 0; i < count(); ++i)
            if (at(time_s)[i].state == "laughs") began.emplace(i, time_s);
    ASSERT_TRUE(began.count(the_joker)) << "it got " << at(joke_s + 1)[the_joker].state;
    EXPECT_GT(began.size(), 1u) << "its neighbours do not laugh";
    for (const auto &[person, since_s] : began) {
        if (person == the_joker) continue;
        double nearest_m = 99;
        for (const auto &[other, other_s] : began)
            if (other_s <= since_s && other != person)
                nearest_m = std::min(nearest_m, apart(at(joke_s)[other].at, at(joke_s)[person].at));
        EXPECT_LT(nearest_m, 1.75) << "person " << person << " laughs alone";
    }
    size_t most = 0, laughs = 0;
    for (double time_s = 210; time_s < 419; time_s += step_s) {
        const size_t now = count_in(time_s, {"laughs"});
        most = std::max(most, now), laughs += now > 0;
    }
    EXPECT_GT(most, 4u) << "no joke of the play makes a group laugh";
    EXPECT_LT(most, count() * 2 / 3) << "all laugh at once";
    EXPECT_LT(static_cast<double>(laughs) * step_s, 130) << "it never ends";
}

TEST_F(Evening, LetsNoneApplaudAlone)
{
    size_t most = 0;
    double few_s = 0;
    for (double time_s = 280; time_s < 340; time_s += step_s) {
        const size_t now = count_in(time_s, {"claps", "cheers"});
        most = std::max(most, now);
        few_s = now > 0 && now < 3 ? few_s + step_s : 0;
        EXPECT_LT(few_s, 12) << "one or two applaud alone at " << time_s;
    }
    EXPECT_GT(most, count() * 6 / 10);
    EXPECT_EQ(count_in(339, {"claps", "cheers"}), 0u);
}

TEST_F(Evening, EndsWithAnEmptyTheatre)
{
    for (size_t i = 0; i < count(); ++i)
        EXPECT_EQ(at(end_s)[i].state, "")
            << "person " << i << " is still at " << at(end_s)[i].at[0] << " " << at(end_s)[i].at[2];
}

TEST(EveningRun, IsTheSameAgainAndAfterARestore)
{
    std::vector<uint64_t> lists;
    std::vector<uint8_t> bytes;
    {
        World world(evening(5, 40), 1, false);
        for (int second = 0; second <= 30; ++second) world.show(second);
        bytes = world.scene->save();
        for (int second = 30; second <= 60; ++second) lists.push_back(world.show(second));
    }
    World again(evening(5, 40), 2, true);
    again.scene->restore(bytes);
    EXPECT_TRUE(again.scene->save() == bytes);
    std::vector<uint64_t> now;
    for (int second = 30; second <= 60; ++second) now.push_back(again.show(second));
    EXPECT_EQ(now, lists);
}

}  // namespace
}  // namespace staged_test
