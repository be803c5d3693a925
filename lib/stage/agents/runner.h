// What a task does to an agent: finds its transition, leaves and enters states, does their actions. It works on a copy
// of the agent and collects what it issues, so that a task either happens as a whole or not at all.
#pragma once

#include "lib/stage/agents/agent.h"
#include "lib/stage/agents/neighbours.h"
#include "lib/stage/flow/command.h"
#include "lib/stage/movement.h"
#include "lib/stage/schedule/task.h"

namespace claque::stage
{

// What a task issues besides the agent's new state.
struct Outcome {
    std::vector<Command> commands;
    std::vector<Task> tasks;
    std::vector<double> crowd;  // the crowd's variables after the task
    uint64_t crowd_changed = 0;
    bool goes = false, stops = false;
    Goal goal;
    struct Call {
        const HostAction *action;
        double value;
    };
    std::vector<Call> calls;  // of `decide`
    bool ran_away = false;
    void clear(const std::vector<double> &crowd_before);
};

// What it reads of the stage.
struct Surroundings {
    const Neighbours *neighbours = nullptr;
    const std::vector<std::unique_ptr<HostAction>> *actions = nullptr;
    const Vocabulary *shared = nullptr;
    uint64_t seed = 0;
    double metres_per_unit = 1;
    double not_before_s = 0;  // when what agents send arrives at the earliest
};

constexpr uint32_t max_instant_transitions = 32;

class Runner : private Nearby
{
public:
    Runner(const Surroundings &around, const Machine &machine, uint32_t index, Agent &agent, Outcome &out)
        : around_(around), machine_(machine), index_(index), agent_(agent), out_(out)
    {
    }
    void run(const Task &task, double now_s);

private:
    // runner.cpp
    void begin();
    void get(const Task &event);
    bool take_first(Trigger trigger, uint32_t event);
    bool holds(const Transition &transition, uint32_t level);
    void settle();
    void take(const Transition &transition, uint32_t level);
    void leave(uint32_t depth);
    void enter(uint32_t target, History history);
    void enter_one(uint32_t state);
    uint32_t chosen_target(const Transition &transition);
    uint32_t depth_to_keep(uint32_t source, uint32_t target) const;
    // arm.cpp
    void wait(uint32_t level);
    void post_repeat(uint32_t level);
    void post_check(uint32_t level);
    void arm_clips();
    void post_clip(uint32_t transition, uint32_t level, double after_s);
    double clip_time(double clip_s, double after_s) const;
    Task of_level(TaskKind kind, uint32_t level, uint32_t index, double due_s) const;
    // actions.cpp
    void act(Range actions, const Level &level);
    void act_one(const Action &action, Situation &at);
    void play(const Action &action, Situation &at);
    void gesture(const Action &action, Situation &at);
    void set(const Action &action, Situation &at);
    void send(const Action &action, Situation &at);
    void look(const Action &action);
    void go(const Action &action, Situation &at);
    void call(const Action &action, Situation &at);
    Command command(CommandKind kind) const;
    double amount(const Quantity &quantity, Situation &at);
    uint32_t chosen_clip(const Action &action, Situation &at);
    Situation situation(double entered_s);

    double nearest_m(uint32_t agent_class) override;
    double count(uint32_t agent_class, double radius_m) override;

    const Surroundings &around_;
    const Machine &machine_;
    uint32_t index_;
    Agent &agent_;
    Outcome &out_;
    double now_s_ = 0;
};

}  // namespace claque::stage
