// A saved stage that is forged in one place at a time, and the sentence that refuses it.
#pragma once

#include <cmath>
#include <functional>
#include <memory>

#include "lib/stage/api/stage_handle.h"
#include "lib/stage/save/fields.h"
#include "tests/unit/stage/stage_world.h"

namespace saved_rules
{

using namespace claque::stage;

inline const char *const machine_of_all = R"toml(
machine = "m"
[variables]
n = 0.0
[crowd]
mood = 0.0
[events]
go = 1
[masks]
hand = { nodes = ["hand"] }
[states.out]
initial = true
transitions = [ { after = 1000, to = "rest" } ]
[states.out.states.in]
initial = true
enter = [ { play = "slow" } ]
while = { every = 500, do = [ { set = "n", to = "n + 1" } ] }
transitions = [ { end = true, if = "n > 1e6", to = "rest" }, { marker = "down", if = "n > 1e6", to = "rest" },
    { if = 'count("", 4) > 50', to = "rest" }, { on = "go", to = "rest" } ]
[states.rest]
)toml";

// It walks nowhere.
struct Standing : Movement {
    void add(AgentIndex, const Walker &, double) override {}
    void remove(AgentIndex, double) override {}
    void go(AgentIndex, const Goal &, double) override {}
    void stop(AgentIndex, double) override {}
    void advance(double, Moved &) override {}
    Place place(AgentIndex, double) const override { return {}; }
    uint32_t cost_of_go() const override { return 0; }
    void save(std::vector<uint8_t> &out) const override { out.push_back(1); }
    void restore(const uint8_t *, size_t) override {}
};

using Forge = std::function<void(SavedStage &)>;

// A stage of three agents: the first is in two states, the second has not begun, the third was removed.
class SavedRules : public testing::Test
{
protected:
    SavedRules()
    {
        const clq_machine made = world_.machine(machine_of_all);
        for (int i = 0; i < 3; ++i) {
            if (i == 1) world_.step(1);
            world_.agent(made, 0, i ? "owl" : "");
        }
        EXPECT_EQ(clq_stage_remove_agent(world_.stage, {3}), CLQ_OK);
        for (const bool shows : {true, false}) {
            auto action = std::make_unique<HostAction>();
            if (shows) action->def.show = [](void *, const clq_action_call *) {};
            director().actions.push_back(std::move(action));
        }
        good_ = snapshot(director(), world_.stage->shown);
        good_.waiting.clear(), good_.messages.clear(), good_.commands.clear();
        for (SavedQueue &queue : good_.queues) queue.tasks.clear();
        good_.timetable.emplace_back();
        good_.timetable[0].task.kind = TaskKind::spread;
    }
    Director &director() { return world_.stage->director; }
    Machine &machine() { return *director().machines[0]; }
    Cast &cast() { return machine().casts[0]; }
    // As if people of the machine could walk: the checks ask no more than whether there is one.
    void give_locomotion() { cast().locomotion = reinterpret_cast<const clq_locomotion *>(&cast()); }

    // The refusal of a copy that was forged; "" if it is taken.
    std::string said(const Forge &forge)
    {
        SavedStage copy = good_;
        forge(copy);
        try {
            check_saved(copy, director());
            return "";
        } catch (const Error &error) {
            EXPECT_EQ(error.status(), CLQ_FORMAT);
            const std::string text = error.what(), head = "the bytes are no saved stage: ";
            EXPECT_EQ(text.rfind(head, 0), 0u) << text;
            return text.substr(std::min(text.size(), head.size()));
        }
    }
    void takes(const Forge &forge, int line) { EXPECT_EQ(said(forge), "") << "line " << line; }
    void refuses(const char *why, const Forge &forge, int line) { EXPECT_EQ(said(forge), why) << "line " << line; }

    // A number of each kind, in and out of its range.
    template <class Get>
    void range(const char *why, const Get &get, const std::vector<double> &inside, const std::vector<double> &outside,
               int line)
    {
        using Number = std::remove_reference_t<decltype(get(good_))>;
        for (const double x : inside) takes([&](SavedStage &s) { get(s) = static_cast<Number>(x); }, line);
        for (const double x : outside)
            refuses(
                why, [&](SavedStage &s) { get(s) = static_cast<Number>(x); }, line);
    }

    // A task in each list that has one.
    Task task(TaskKind kind)
    {
        Task out;
        out.kind = kind;
        out.agent = 0;
        return out;
    }
    // Of a state of the first agent: level 0 is "out", 1 is "in".
    Task of_level(TaskKind kind, uint8_t level, Trigger trigger)
    {
        Task out = task(kind);
        out.level = level, out.serial = good_.agents[0].path[level].serial, out.play_serial = 1;
        const Range &own = machine().states[good_.agents[0].path[level].state].transitions;
        for (uint32_t i = own.first; i < own.first + own.count; ++i)
            if (machine().transitions[i].trigger == trigger) out.index = i;
        EXPECT_EQ(machine().transitions[out.index].trigger, trigger);
        return out;
    }
    static Forge waiting(const Task &task)
    {
        return [=](SavedStage &s) { s.waiting.push_back(task); };
    }
    static Forge commanded(const SavedCommand &command)
    {
        return [=](SavedStage &s) { s.commands.push_back(command); };
    }

    StageWorld world_;
    SavedStage good_;
};

#define TAKES(...) takes(__VA_ARGS__, __LINE__)
#define REFUSES(why, ...) refuses(why, __VA_ARGS__, __LINE__)
#define RANGE(why, get, ...) \
    range(                   \
        why, [&](SavedStage & s) -> auto & { return get; }, __VA_ARGS__, __LINE__)

inline const std::vector<double> places = {1e12, -1e12, 0}, nowhere = {1.001e12, -1.001e12, NAN, INFINITY};

}  // namespace saved_rules
