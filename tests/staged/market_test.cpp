// The market of samples/scenarios/market.toml: people go through no person and no stall. Talking people face each
// other, and the owl startles the people near it.
#include <algorithm>
#include <cmath>

#include "samples/scenes/town/walkable.h"
#include "samples/stage/flyers.h"
#include "tests/staged/staged_world.h"

namespace staged_test
{
namespace
{

using namespace scenes;
using Point3 = std::array<double, 3>;

// With a tenth of its people, or so many.
Scenario market(uint32_t citizens, uint32_t patricians, uint32_t plebeians)
{
    Scenario scenario = load_scenario(std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/market.toml");
    const uint32_t counts[] = {citizens, patricians, plebeians};
    for (size_t i = 0; i < 3; ++i) scenario.stage->agents.at(1 + i).count = counts[i];
    return scenario;
}

const town::Walkable &the_square()
{
    static const town::Walkable found = town::walkable_square(town::Town(1, town::Trade::market_day), 30);
    return found;
}

bool is_in_one(const std::vector<town::Walkable::Prism> &prisms, const Point3 &at)
{
    const auto holds = [&](const town::Walkable::Prism &one) {
        bool left = false, right = false;
        const size_t count = one.outline.size() / 2;
        for (size_t i = 0; i < count; ++i) {
            const size_t next = (i + 1) % count;
            const double ax = one.outline[2 * i], az = one.outline[2 * i + 1];
            const double side =
                (one.outline[2 * next] - ax) * (at[2] - az) - (one.outline[2 * next + 1] - az) * (at[0] - ax);
            (side < 0 ? left : right) = true;
        }
        return !(left && right);
    };
    return std::any_of(prisms.begin(), prisms.end(), holds);
}

std::string state_of(staged::Run &run, uint32_t person)
{
    clq_agent_info info = clq_agent_info_init();
    check(clq_stage_get_agent(run.handle(), run.agent_of(person), &info));
    return info.state;
}

// As they are drawn.
clq_transform drawn(World &world, uint32_t person)
{
    clq_actor_info info = clq_actor_info_init();
    check(clq_actor_get_info(world.scene->crowd(), world.run().people().all()[person].actor, &info));
    return info.root;
}

TEST(Market, PeopleGoThroughNoPersonAndNoThing)
{
    World world(market(60, 20, 50), 1, false);
    const auto count = static_cast<uint32_t>(world.run().people().all().size());
    double nearest_m = HUGE_VAL, walked_m = 0;
    size_t in_something = 0, in_booths = 0, at_posts = 0, samples = 0;
    std::vector<Point3> before;
    for (double time_s = 0; time_s <= 60; time_s += 0.2) {
        world.scene->place(time_s);
        std::vector<Point3> here;
        for (uint32_t i = 0; i < count; ++i) {
            here.push_back(world.run().place_of(i));
            in_something += is_in_one(the_square().obstacles, here.back());
            const bool sells = world.run().agents_of(i).name == "sellers";
            if (time_s > 30) (sells ? at_posts : in_booths) += is_in_one(the_square().booths, here.back());
            for (uint32_t k = 0; k < i; ++k) {
                nearest_m = std::min(nearest_m, std::hypot(here[i][0] - here[k][0], here[i][2] - here[k][2]));
            }
            ++samples;
            if (!before.empty()) walked_m += std::hypot(here[i][0] - before[i][0], here[i][2] - before[i][2]);
        }
        before = here;
    }
    std::printf("market: the nearest two are %.3f m apart; %.1f m walked by each; %zu of %zu times in a booth\n",
                nearest_m, walked_m / count, in_booths, samples);
    EXPECT_EQ(in_something, 0u);
    EXPECT_LT(static_cast<double>(in_booths), 0.003 * static_cast<double>(samples)) << "but for some who fled there";
    EXPECT_GT(at_posts, 24u * 140) << "those who sell stand in them";
    EXPECT_GT(nearest_m, 0.32);  // as shown; as they walk, 0.4, or 0.34 with turned shoulders
    EXPECT_GT(walked_m / count, 12);
    EXPECT_EQ(world.run().counts().refused, 0u);
    EXPECT_EQ(world.run().info().runaways, 0u);
}

// Of the place of another one: how far, and the cosine of the angle from where it looks to there.
struct Sight {
    double distance, ahead;
};

Sight sight(const clq_transform &me, const clq_transform &other)
{
    const double x = other.position[0] - me.position[0], z = other.position[2] - me.position[2];
    const double y = static_cast<double>(me.orientation_xyzw[1]), w = static_cast<double>(me.orientation_xyzw[3]);
    const double distance = std::hypot(x, z);
    return {distance, (x * 2 * y * w + z * (w * w - y * y)) / distance};
}

// One whom it talks with: near, before it, and turned to it.
bool has_company(World &world, uint32_t person, const std::vector<std::string> &states)
{
    const clq_transform me = drawn(world, person);
    for (uint32_t k = 0; k < states.size(); ++k) {
        if (k == person || (states[k] != "speaks" && states[k] != "listens")) continue;
        const clq_transform other = drawn(world, k);
        const Sight one = sight(me, other);
        if (one.distance < 1.7 && one.ahead > 0.8 && sight(other, me).ahead > 0.8) return true;
    }
    return false;
}

TEST(Market, PeopleWhoTalkFaceEachOther)
{
    World world(market(40, 10, 30), 1, false);
    const auto count = static_cast<uint32_t>(world.run().people().all().size());
    size_t seen = 0, facing = 0;
    std::vector<std::string> states(count);  // of the time shown, which is a second behind the time decided
    for (double time_s = 0; time_s <= 60; time_s += 1) {
        world.show(time_s);
        for (uint32_t i = 0; i < count; ++i) {
            if (states[i] != "speaks") continue;
            ++seen;
            facing += has_company(world, i, states);
        }
        for (uint32_t i = 0; i < count; ++i) states[i] = state_of(world.run(), i);
    }
    std::printf("market: %zu speakers seen, %zu face another one\n", seen, facing);
    EXPECT_GT(seen, 30u);
    EXPECT_GT(static_cast<double>(facing), 0.9 * static_cast<double>(seen));
}

TEST(Market, TheOwlStartlesThoseNearItAndTheyGoOn)
{
    const Scenario scenario = market(60, 20, 50);
    World world(scenario, 1, false);
    const auto count = static_cast<uint32_t>(world.run().people().all().size());
    const ScenarioFlyer &owl = scenario.stage->flyers.at(0);
    std::vector<double> since(count, -1);
    size_t startled = 0, far = 0, again = 0;
    for (double time_s = 0.05; time_s <= 40; time_s += 0.05) {
        world.run().decide(time_s);
        for (uint32_t i = 0; i < count; ++i) {
            const std::string state = state_of(world.run(), i);
            const bool is = state == "gapes" || state == "ducks" || state == "runs" || state == "startled";
            if (is && since[i] < 0) {
                const Point3 at = world.run().place_of(i), over = staged::place_in_flight(owl, time_s);
                ++startled, since[i] = time_s;
                far += std::hypot(at[0] - over[0], at[1] - over[1], at[2] - over[2]) > owl.radius_m + 1;
            }
            if (!is && since[i] >= 0) ++again, since[i] = -1;
            EXPECT_FALSE(since[i] >= 0 && time_s - since[i] > 6) << "person " << i << " does not go on";
        }
    }
    std::printf("market: %zu startled, %zu went on\n", startled, again);
    EXPECT_GT(startled, 20u);
    EXPECT_EQ(far, 0u);
    EXPECT_GT(again + 12, startled);
}

TEST(Market, TheOwlIsDrawnWhereItIsHeard)
{
    World world(market(2, 1, 1), 1, false);
    const ScenarioFlyer owl = world.run().stage().flyers.at(0);
    clq_template *tmpl = world.library.builtin("owl");
    const clq_actor actor = {static_cast<uint32_t>(world.run().people().all().size() + 1),
                             1};  // the first one after the people
    const uint32_t body = clq_template_find_node(tmpl, "body");
    ASSERT_NE(body, CLQ_NONE);
    for (const double time_s : {0.5, 3.0, 11.0, 26.0}) {
        world.show(time_s);
        double node[16];
        ASSERT_EQ(clq_actor_get_node(world.scene->crowd(), actor, body, time_s, node), CLQ_OK) << clq_last_error();
        const Point3 place = staged::place_in_flight(owl, time_s);
        EXPECT_LT(std::hypot(node[12] - place[0], node[13] - place[1], node[14] - place[2]), 0.6) << time_s;
    }
}

TEST(Market, IsTheSameAgainAndAfterARestore)
{
    std::vector<uint64_t> lists;
    std::vector<uint8_t> bytes;
    {
        World world(market(20, 5, 15), 1, false);
        for (int second = 0; second <= 12; ++second) world.show(second);
        bytes = world.scene->save();
        for (int second = 12; second <= 24; ++second) lists.push_back(world.show(second));
    }
    World again(market(20, 5, 15), 2, true);
    again.scene->restore(bytes);
    EXPECT_TRUE(again.scene->save() == bytes);
    std::vector<uint64_t> now;
    for (int second = 12; second <= 24; ++second) now.push_back(again.show(second));
    EXPECT_EQ(now, lists);
}

}  // namespace
}  // namespace staged_test
