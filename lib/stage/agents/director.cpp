#include "lib/stage/agents/director.h"

#include <algorithm>
#include <cmath>

#include "lib/stage/error.h"
#include "lib/stage/hash.h"
#include "lib/stage/host_call.h"

namespace claque::stage
{

namespace
{

constexpr double max_ticks = 1e6;  // of one step

Limits limits_of(const clq_stage_def &def)
{
    Limits out;
    const bool live = def.mode == CLQ_STAGE_LIVE;
    out.budget = live ? static_cast<double>(def.budget_us) : static_cast<double>(def.budget);
    for (uint32_t c = 0; c < class_count; ++c) out.shares[c] = static_cast<double>(def.shares[c]);
    if (live) out.now_s = def.now_s, out.now_user = def.now_user;
    return out;
}

}  // namespace

Director::Director(clq_context *with, const clq_stage_def &wanted)
    : context(with),
      def(wanted),
      neighbours(static_cast<double>(wanted.metres_per_unit)),
      scheduler(limits_of(wanted)),
      handover(wanted.start_s),
      hash(start_of_sum)
{
    inbox.change([&](Inbox::Directory &directory) { directory.shared = shared; });
}

double Director::after_s() const { return std::nextafter(end_s(), INFINITY); }

void Director::step(double until_s)
{
    // A tick that ends at until_s up to rounding ends there.
    const double missing = (until_s - def.start_s) / def.tick_s - static_cast<double>(tick);
    if (missing > max_ticks)
        fail(CLQ_LIMIT, "%.0f ticks of %g s are missing up to %g s: a step decides %.0f at most", missing, def.tick_s,
             until_s, max_ticks);
    while (end_s() <= until_s + 1e-9 * def.tick_s) run_tick();
}

void Director::run_tick()
{
    switch (phase_) {
        case Phase::messages:
            take_messages();
            phase_ = Phase::tasks;
            [[fallthrough]];
        case Phase::tasks:
            scheduler.run(begin_s(), end_s(), *this);
            phase_ = Phase::crowd;
            [[fallthrough]];
        case Phase::crowd:
            wake_readers();
            phase_ = Phase::movement;
            [[fallthrough]];
        case Phase::movement:
            if (movement) movement->advance(end_s(), moved_);
            phase_ = Phase::moved;
            [[fallthrough]];
        case Phase::moved:
            take_moved();
            phase_ = Phase::commands;
            [[fallthrough]];
        case Phase::commands:
            publish();
            phase_ = Phase::messages;
    }
}

void Director::make_room(size_t more, const char *from, const std::string &name)
{
    const size_t most = most_waiting(agents.size());
    if (scheduler.held() + more > most) scheduler.sweep(*this);
    if (scheduler.held() + more > most)
        fail(CLQ_LIMIT, "%zu tasks wait, and %s%.80s would bring %zu more: %zu may wait, 2^20 and 64 for each agent",
             scheduler.held(), from, name.c_str(), more, most);
    scheduler.reserve(more);
}

void Director::take_messages()
{
    if (messages_.empty()) inbox.take(messages_);
    make_room(messages_.size(), "messages", "");
    for (const Task &message : messages_) {
        late_messages += message.due_s <= begin_s();
        scheduler.add_message(message);
    }
    messages_.clear();
}

bool Director::is_alive(const Task &task) const
{
    const Agent &agent = agents[task.agent];
    if (agent.is_removed) return false;
    if (task.kind == TaskKind::begin) return true;
    if (task.kind == TaskKind::event) return task.serial == 0 || task.serial == agent.request;
    if (task.serial == 0) return true;
    if (task.level >= agent.depth || agent.path[task.level].serial != task.serial) return false;
    return task.play_serial == 0 || task.play_serial == agent.play_serial;
}

void Director::fetch(uint32_t agent) const
{
    if (agent >= agents.size()) return;  // a task of the stage itself, whose agent a saved state may call anything
    const char *at = reinterpret_cast<const char *>(&agents[agent]);
    for (size_t i = 0; i < sizeof(Agent); i += 64) __builtin_prefetch(at + i);
}

uint32_t Director::class_of(const Task &task) const
{
    return std::min(class_count - 1, task.priority + (agents[task.agent].in_view ? 0u : 1u));
}

uint32_t Director::cost_of(const Task &task) const
{
    const Agent &agent = agents[task.agent];
    const Machine &machine = *machines[agent.machine];
    const Level *in = agent.innermost();
    return machine.states[in ? in->state : machine.initial].cost;
}

void Director::prepare(const Task &task)
{
    switch (task.kind) {
        case TaskKind::spread:
            return spread(task);
        case TaskKind::timetable:
            return enter_timetable(task);
        case TaskKind::set:
            return set_variable(task);
        default:
            return set_view(task);
    }
}

// Finds those that get an event.
void Director::spread(const Task &task)
{
    found_.clear();
    if (task.radius_m > 0) {
        neighbours.within(task.place, task.radius_m, task.agent_class, found_);
    } else {
        for (uint32_t i = 0; i < agents.size(); ++i)
            if (!agents[i].is_removed && (task.agent_class == none || agents[i].agent_class == task.agent_class))
                found_.push_back({i, task.per_m_s > 0 ? neighbours.distance_m(agents[i].position, task.place) : 0});
    }
    make_room(found_.size(), "the event ", shared.events[task.index].name);
    Task one = task;
    one.kind = TaskKind::event;
    for (const Neighbours::Found &found : found_) {
        if (found.agent == task.sender) continue;
        one.agent = found.agent;
        one.due_s = task.due_s + task.per_m_s * found.distance_m;
        scheduler.add(one);
    }
}

void Director::enter_timetable(const Task &task)
{
    const Entry &entry = timetable[task.index];
    make_room(2, "the timetable", "");
    Task event = entry.task;
    event.due_s = task.due_s;
    scheduler.add(event);
    if (entry.every_s <= 0) return;
    // Entered so far; of those that were over before this tick only one happens.
    const double over = std::floor((begin_s() - entry.task.due_s) / entry.every_s);
    const double count = std::max(task.value, over) + 1;
    if (entry.times && count >= entry.times) return;
    Task next = task;
    next.due_s = entry.task.due_s + count * entry.every_s;
    next.value = count;
    scheduler.add(next);
}

void Director::set_variable(const Task &task)
{
    if (task.agent == none) {
        if (!(crowd[task.index] == task.value)) crowd_changed |= uint64_t(1) << task.index;
        crowd[task.index] = task.value;
        return;
    }
    Agent &agent = agents[task.agent];
    if (agent.is_removed || task.index >= agent.variables.size()) return;
    make_room(1, "a variable", "");
    agent.variables[task.index] = task.value;
    Task check;
    check.kind = TaskKind::check;
    check.agent = task.agent;
    check.due_s = task.due_s;
    check.priority = 1;
    scheduler.add(check);
}

void Director::set_view(const Task &task)
{
    Agent &agent = agents[task.agent];
    const bool in_view = task.value != 0;
    if (agent.is_removed || agent.in_view == in_view) return;
    make_room(1, "a view", "");
    agent.in_view = in_view;
    Task event;
    event.kind = TaskKind::event;
    event.agent = task.agent;
    event.due_s = task.due_s;
    event.index = in_view ? event_seen : event_unseen;
    event.priority = shared.events[event.index].priority;
    scheduler.add(event);
}

void Director::run(const Task &task, bool late)
{
    scratch_ = agents[task.agent];
    outcome_.clear(crowd);
    Surroundings around;
    around.neighbours = &neighbours;
    around.actions = &actions;
    around.shared = &shared;
    around.seed = def.seed;
    around.metres_per_unit = static_cast<double>(def.metres_per_unit);
    around.not_before_s = after_s();
    Runner(around, *machines[scratch_.machine], task.agent, scratch_, outcome_).run(task, late ? end_s() : task.due_s);
    commit(task);
}

void Director::commit(const Task &task)
{
    if (commands.capacity() < commands.size() + outcome_.commands.size())
        commands.reserve(2 * (commands.size() + outcome_.commands.size()));
    make_room(outcome_.tasks.size(), "the machine ", machines[agents[task.agent].machine]->name);
    if (outcome_.goes) movement->go(task.agent, outcome_.goal, scratch_.now_s);
    if (outcome_.stops && scratch_.is_walker) movement->stop(task.agent, scratch_.now_s);
    // Nothing below throws.
    Agent &agent = agents[task.agent];
    transitions += scratch_.transitions - agent.transitions;
    events += task.kind == TaskKind::event;
    std::swap(agent, scratch_);
    crowd.swap(outcome_.crowd);
    crowd_changed |= outcome_.crowd_changed;
    for (const Task &next : outcome_.tasks) scheduler.add(next);
    for (Command &command : outcome_.commands) {
        command.order = static_cast<uint32_t>(commands.size());
        commands.push_back(command);
    }
    if (outcome_.ran_away && runaways++ == 0) {
        const std::string &state = machines[agent.machine]->states[agent.innermost()->state].name;
        char text[256];
        std::snprintf(text, sizeof text,
                      "agent %u was stopped after %u instant transitions in a row, in the state '%.80s'",
                      task.agent + 1, max_instant_transitions, state.c_str());
        clq_context_log(context, CLQ_LOG_WARNING, text);
    }
    for (const Outcome::Call &call : outcome_.calls) {
        const clq_action_call made = {{task.agent + 1}, agent.actor, agent.now_s, call.value, nullptr};
        call_host(context, call.action->name.c_str(), [&] { call.action->def.decide(call.action->def.user, &made); });
    }
}

// Conditions that read a variable of the crowd are checked in the next tick after it has changed.
void Director::wake_readers()
{
    if (crowd_changed == 0) return;
    make_room(agents.size(), "a variable of the crowd", "");
    Task check;
    check.kind = TaskKind::check;
    check.due_s = after_s();
    check.priority = 1;
    for (uint32_t i = 0; i < agents.size(); ++i) {
        const Agent &agent = agents[i];
        const Machine &machine = *machines[agent.machine];
        uint64_t reads = 0;
        for (uint32_t level = 0; level < agent.depth; ++level)
            reads |= machine.states[agent.path[level].state].crowd_reads;
        if (agent.is_removed || !(reads & crowd_changed)) continue;
        check.agent = i;
        scheduler.add(check);
    }
    crowd_changed = 0;
}

}  // namespace claque::stage
