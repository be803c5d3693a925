// Decides: runs the tasks of all agents, tick by tick, and hands the commands to the drawing flow.
//
// A tick is a row of steps, each of which either happens as a whole or not at all; an exception leaves the tick where
// it is, and the next call of step() goes on from there.
#pragma once

#include <claque/stage.h>

#include <memory>
#include <utility>
#include <vector>

#include "lib/stage/agents/runner.h"
#include "lib/stage/flow/handover.h"
#include "lib/stage/flow/inbox.h"
#include "lib/stage/schedule/scheduler.h"

namespace claque::stage
{

// An entry of a timetable.
struct Entry {
    Task task;           // its first event
    double every_s = 0;  // 0: once
    uint32_t times = 0;  // 0: for ever
};

struct SavedStage;

class Director : public Worker
{
public:
    Director(clq_context *context, const clq_stage_def &def);

    void step(double until_s);
    double time_of(uint64_t tick) const { return def.start_s + static_cast<double>(tick) * def.tick_s; }
    double decided_s() const { return time_of(tick); }

    uint32_t add_agent(Agent &&agent, const std::string &agent_class, double start_s);
    void remove_agent(uint32_t agent);
    void set_place(uint32_t agent, const double position[3]);
    void add_machine(std::unique_ptr<Machine> machine, Vocabulary &&with);
    void add_action(std::unique_ptr<HostAction> action);
    void add_entries(std::vector<Entry> &&entries);
    clq_stage_info info() const;
    // Replaces the state. If it throws, nothing has changed; otherwise `commands` is empty afterwards.
    void restore(SavedStage &&saved, Scheduler &&tasks, Neighbours &&places, std::vector<Command> &commands_left);
    bool is_between_ticks() const { return phase_ == Phase::messages && !scheduler.is_open(); }
    const std::vector<Task> &messages_taken() const { return messages_; }

    bool is_alive(const Task &task) const override;

    // All state; save.cpp walks it.
    clq_context *context;
    const clq_stage_def def;
    Vocabulary shared;
    std::vector<std::unique_ptr<HostAction>> actions;
    std::vector<std::unique_ptr<Machine>> machines;
    std::vector<Agent> agents;
    std::vector<double> crowd;
    std::vector<Entry> timetable;
    Neighbours neighbours;
    Scheduler scheduler;
    std::unique_ptr<Movement> movement;
    Handover handover;
    Inbox inbox;
    std::vector<Command> commands;  // of the tick at work
    uint64_t tick = 0, crowd_changed = 0;
    uint64_t transitions = 0, events = 0, command_count = 0, late_messages = 0, runaways = 0, hash;
    uint32_t live_agents = 0;

private:
    enum class Phase : uint8_t { messages, tasks, crowd, movement, moved, commands };

    void fetch(uint32_t agent) const override;
    uint32_t class_of(const Task &task) const override;
    uint32_t cost_of(const Task &task) const override;
    void prepare(const Task &task) override;
    void run(const Task &task, bool late) override;

    // For more tasks, which `from`, of that name, brings; LIMIT if too many would wait.
    void make_room(size_t more, const char *from, const std::string &name);
    void run_tick();
    void take_messages();
    void spread(const Task &task);
    void enter_timetable(const Task &task);
    void set_variable(const Task &task);
    void set_view(const Task &task);
    void commit(const Task &task);
    void wake_readers();
    void take_moved();
    void play_on(const Piece &piece);
    void publish();
    double begin_s() const { return time_of(tick); }
    double end_s() const { return time_of(tick + 1); }
    double after_s() const;  // the first time of the next tick

    Phase phase_ = Phase::messages;
    std::vector<Task> messages_;
    std::vector<Neighbours::Found> found_;
    std::vector<std::pair<double, uint32_t>> keys_;
    std::vector<Command> ordered_;
    Moved moved_;
    Agent scratch_;
    Outcome outcome_;
};

}  // namespace claque::stage
