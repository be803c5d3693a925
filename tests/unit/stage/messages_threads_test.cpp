// What any thread may tell a stage and ask of it while another one decides and a third one draws. To be run under a
// thread sanitizer as well.
#include <atomic>
#include <thread>

#include "tests/unit/stage/stage_world.h"

namespace
{

const char *const two_states = R"toml(
[states.a]
initial = true
transitions = [ { on = "go", to = "b" } ]
[states.b]
transitions = [ { on = "seen", to = "a" }, { on = "back", to = "a" }, { after = 0.3, to = "a" } ]
)toml";

// Scripts on two threads speak to agents that the decisions add and remove meanwhile, and a third thread asks.
TEST(Messages, OfAnyThreadAreTakenAtAnyTime)
{
    StageWorld world;
    const clq_machine machine = world.machine(machine_text(two_states));
    std::atomic<bool> done{false};
    std::atomic<uint32_t> newest{world.agent(machine).index1}, told{0}, rounds[2] = {{0}, {0}}, steps{0};
    const auto note = [&](clq_status status) {
        EXPECT_TRUE(status == CLQ_OK || status == CLQ_STALE_ID) << clq_last_error();
        told += status == CLQ_OK;
    };
    const auto speak = [&](const char *name, std::atomic<uint32_t> &spoken) {
        // A step that waits for its turn must not meet more tasks than a stage holds: 8 rounds, and then the next step.
        for (uint32_t step = 0, left = 0; !done && !HasFailure();) {
            if (step != steps) step = steps, left = 8;
            if (left == 0) {
                std::this_thread::yield();
                continue;
            }
            --left;
            const clq_agent agent = {newest};
            const double now_s = clq_stage_get_decided_s(world.stage);
            const bool in_view = told % 2 == 0;
            clq_stage_event event = clq_stage_event_init();
            event.name = name, event.at_s = now_s, event.to = agent;
            note(clq_stage_send(world.stage, &event));
            event.to = {0}, event.radius_m = 4, event.sender = agent;
            note(clq_stage_send(world.stage, &event));
            note(clq_stage_set_variable(world.stage, agent, "n", 2, now_s + 0.1));
            note(clq_stage_set_variable(world.stage, {0}, "mood", 3, now_s));
            note(clq_stage_tell_view(world.stage, &agent, &in_view, 1, now_s));
            ++spoken;
            std::this_thread::yield();
        }
    };
    const auto ask = [&] {
        uint64_t ticks = 0;
        while (!done && !HasFailure()) {
            clq_stage_info info = clq_stage_info_init();
            EXPECT_EQ(clq_stage_get_info(world.stage, &info), CLQ_OK);
            EXPECT_GE(info.ticks, ticks);
            ticks = info.ticks;
            std::this_thread::yield();
        }
    };
    const auto draw = [&] {
        while (!done && !HasFailure()) {
            const double time_s = clq_stage_get_decided_s(world.stage);
            EXPECT_EQ(clq_stage_apply(world.stage, world.arm.crowd, time_s, nullptr), CLQ_OK) << clq_last_error();
            EXPECT_EQ(clq_crowd_update(world.arm.crowd, time_s, nullptr, 0), CLQ_OK) << clq_last_error();
            std::this_thread::yield();
        }
    };
    // Both have spoken to the newest agent: the second of the rounds that end from now on began after now. Speakers
    // that took their rounds of this step already could not end another, so they are counted before the step begins.
    const auto hear_both = [&] {
        const uint32_t until[] = {rounds[0] + 2, rounds[1] + 2};
        ++steps;
        for (int i = 0; i < 2; ++i)
            while (rounds[i] < until[i] && !HasFailure()) std::this_thread::yield();
    };
    std::thread others[] = {std::thread(speak, "go", std::ref(rounds[0])),
                            std::thread(speak, "back", std::ref(rounds[1])), std::thread(ask), std::thread(draw)};
    for (int step = 1; step <= 60 && !HasFailure(); ++step) {
        hear_both();
        EXPECT_EQ(clq_stage_step(world.stage, 0.1 * step), CLQ_OK) << clq_last_error();
        const clq_agent gone = {newest};
        newest = world.agent(machine).index1;
        if (step % 3 == 0) {
            EXPECT_EQ(clq_stage_remove_agent(world.stage, gone), CLQ_OK) << clq_last_error();
        }
        std::this_thread::yield();
    }
    done = true;
    for (std::thread &other : others) other.join();
    EXPECT_GE(world.info().transitions, 60u) << "each step met an agent that was told to go";
    EXPECT_GE(told, 60u * 2 * 5);
}

}  // namespace
