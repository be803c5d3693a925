// Actions, the clock and the writer of a stage run under the floating-point settings of the host, and what is decided
// does not depend on them.
#include "tests/support/host_floats.h"

#include <map>

#include "tests/unit/stage/stage_world.h"

namespace
{

using host_floats::Callback;
using host_floats::Words;

// Callbacks that met the settings of `hosts`, by their names; and how many did not.
struct Told {
    Words hosts;
    std::map<std::string, int> right;
    int wrong = 0;

    void note(const char *name)
    {
        const bool is_right = host_floats::now().control == hosts.control;
        const Callback calm(hosts);
        is_right ? ++right[name] : ++wrong;
    }
};

// Runs `call` under the settings of the host, which it must leave as they were.
template <class Call>
void call_under(const Words &hosts, const Call &call)
{
    const Words before = host_floats::now();
    host_floats::set(hosts);
    const Words found = host_floats::now();
    const clq_status status = call();
    const Words left = host_floats::now();
    host_floats::set(before);
    EXPECT_EQ(status, CLQ_OK) << clq_last_error();
    EXPECT_TRUE(left == found);
}

uint64_t decided_under(const Words &hosts, Told &told)
{
    told.hosts = hosts;
    clq_stage_def def = clq_stage_def_init();
    def.mode = CLQ_STAGE_LIVE, def.budget_us = 1e6f, def.now_user = &told;
    def.now_s = [](void *user) { return static_cast<Told *>(user)->note("now_s"), 0.0; };
    StageWorld world(&def);
    clq_action_def action = clq_action_def_init();
    action.name = "ring", action.user = &told;
    action.decide = [](void *user, const clq_action_call *) { static_cast<Told *>(user)->note("decide"); };
    action.show = [](void *user, const clq_action_call *) { static_cast<Told *>(user)->note("show"); };
    EXPECT_EQ(clq_stage_add_action(world.stage, &action), CLQ_OK);
    world.actor_agent(
        world.machine(machine_text("[states.a]\ninitial = true\nwhile = { every = 0.3, do = [ { call = "
                                   "\"ring\", value = \"clock / 3\" }, { set = \"n\", to = \"n + clock / "
                                   "7\" }, { play = \"fast\", speed = \"1 + n / 11\" } ] }\n")));
    call_under(hosts, [&] { return clq_stage_step(world.stage, 3.0); });
    call_under(hosts, [&] { return clq_stage_apply(world.stage, world.arm.crowd, 2.0, nullptr); });
    call_under(hosts, [&] {
        const auto write = [](void *user, const void *, size_t) { return static_cast<Told *>(user)->note("write"), 0; };
        return clq_stage_save(world.stage, write, &told);
    });
    return world.info().hash ^ clq_crowd_get_hash(world.arm.crowd);
}

TEST(StageFloats, OfTheHostAreMetByItsCallbacksAndDecideNothing)
{
    if (host_floats::settings().empty()) GTEST_SKIP() << "the settings of this processor are not known here";
    Told usual;
    const uint64_t hash = decided_under(host_floats::settings()[0].words, usual);
    for (const host_floats::Setting &setting : host_floats::settings()) {
        Told told;
        EXPECT_EQ(decided_under(setting.words, told), hash) << setting.name;
        EXPECT_EQ(told.wrong, 0) << setting.name;
        EXPECT_EQ(told.right.size(), 4u) << setting.name << ": decide, show, now_s and write";
    }
}

}  // namespace
