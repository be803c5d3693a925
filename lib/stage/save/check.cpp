// Bytes that claim to be a saved stage are checked before anything believes them.
#include <algorithm>
#include <cmath>

#include "lib/stage/save/fields.h"

namespace claque::stage
{

namespace
{

void must(bool rule, const char *what)
{
    if (!rule) bad_save(what);
}

bool is_place(const double position[3])
{
    return std::fabs(position[0]) <= 1e12 && std::fabs(position[1]) <= 1e12 && std::fabs(position[2]) <= 1e12;
}

constexpr double latest_s = 1e10;

bool is_truth(uint8_t value) { return value <= 1; }

class Check
{
public:
    Check(const SavedStage &saved, const Director &director) : saved_(saved), director_(director) {}

    void all() const
    {
        must(saved_.crowd.size() == director_.crowd.size(), "the crowd has other variables");
        must(!saved_.classes.empty() && saved_.classes[0].empty(), "the classes of agents are wrong");
        for (const Agent &one : saved_.agents) agent(one);
        for (const Entry &entry : saved_.timetable) {
            must(entry.task.kind == TaskKind::spread, "a timetable sends no event");
            must(entry.every_s == 0 || (entry.every_s >= 0.01 && entry.every_s <= 1e9), "a timetable repeats wrongly");
            task(entry.task, true);
        }
        for (const Task &one : saved_.waiting) task(one, true);
        for (const Task &one : saved_.messages) task(one, true);
        for (const SavedQueue &queue : saved_.queues) {
            for (const Task &one : queue.tasks) task(one, false);
            must(queue.credit >= 0 && std::isfinite(queue.credit), "a class has no credit");
        }
        for (const clq_stage_class_info &one : saved_.done)
            must(one.longest_wait_s >= 0 && std::isfinite(one.longest_wait_s), "a class has waited for no time");
        must(saved_.next_order >= own_order && saved_.unit_us >= 0 && std::isfinite(saved_.unit_us) &&
                 director_.time_of(saved_.tick) <= latest_s && std::isfinite(saved_.shown_s),
             "a count is too large");
        for (const SavedCommand &one : saved_.commands) command(one);
        must(saved_.rows.size() <= saved_.agents.size(), "more actors than agents");
        for (size_t i = 0; i < saved_.rows.size(); ++i)
            for (const std::vector<uint8_t> &track : saved_.rows[i].tracks)
                must(track.empty() || locomotion_of(static_cast<uint32_t>(i)), "an actor walks that cannot");
        for (const SavedMask &one : saved_.masks) mask(one.machine, one.cast, one.mask);
        must(saved_.movement.empty() == (director_.movement == nullptr), "its agents walk otherwise");
    }

private:
    const Machine &machine_of(uint32_t agent) const { return *director_.machines[saved_.agents[agent].machine]; }
    const clq_locomotion *locomotion_of(uint32_t agent) const
    {
        return machine_of(agent).casts[saved_.agents[agent].cast].locomotion;
    }

    void agent(const Agent &one) const
    {
        must(one.machine < director_.machines.size(), "an agent runs a machine that there is not");
        const Machine &machine = *director_.machines[one.machine];
        must(one.cast < machine.casts.size() && one.agent_class < saved_.classes.size(), "an agent has no template");
        must(one.scale > 0 && std::isfinite(one.scale) && std::isfinite(one.heading_rad) && is_place(one.position) &&
                 one.now_s <= director_.time_of(saved_.tick),
             "an agent is nowhere");
        must(!one.has_origin || is_place(one.origin), "an event happened nowhere");
        must(one.sender == none || one.sender < saved_.agents.size(), "an event has no sender");
        must(!one.is_walker || (director_.movement && machine.casts[one.cast].locomotion),
             "an agent walks that cannot");
        const bool begun = one.depth > 0;
        must(one.variables.size() == machine.variables.size() || (!begun && one.variables.empty()),
             "an agent has other variables");
        must(one.last.size() == machine.states.size() || (!begun && one.last.empty()), "an agent has other states");
        path(one, machine);
        must(one.clip == none || one.clip < machine.clip_names.size(), "an agent plays an unknown clip");
        must(one.play_speed >= 0.005 && one.play_speed <= 200 && std::fabs(one.play_phase_s) <= 1e9 &&
                 std::fabs(one.play_start_s) <= latest_s,
             "an agent plays no clip");
    }

    static void path(const Agent &one, const Machine &machine)
    {
        for (uint32_t i = 0; i < one.depth; ++i) {
            const Level &level = one.path[i];
            must(level.state < machine.states.size() && level.serial != 0 && level.serial < one.next_serial &&
                     std::isfinite(level.entered_s),
                 "an agent is in an unknown state");
            must(machine.states[level.state].parent == (i ? one.path[i - 1].state : none),
                 "an agent is in states that do not hold each other");
        }
        must(one.depth == 0 || machine.states[one.path[one.depth - 1].state].initial == none,
             "an agent is in no innermost state");
        for (size_t i = 0; i < one.last.size(); ++i)
            must(
                one.last[i] == none || (one.last[i] < machine.states.size() && machine.states[one.last[i]].parent == i),
                "the history of an agent is wrong");
    }

    void task(const Task &one, bool may_be_of_stage) const
    {
        must(std::isfinite(one.due_s) && std::fabs(one.due_s) <= 1e15, "a task is never due");
        must(one.priority < class_count && is_truth(one.has_place), "a task has no class");
        must(may_be_of_stage || !is_of_stage(one.kind), "a task of the stage has a class");
        must(one.sender == none || one.sender < saved_.agents.size(), "an event has no sender");
        must(one.agent_class == none || one.agent_class < saved_.classes.size(), "an event is for an unknown class");
        must(one.radius_m >= 0 && one.radius_m <= 1e30 && one.per_m_s >= 0 && one.per_m_s <= 1e7,
             "an event has no reach");
        must(!one.has_place || is_place(one.place), "an event happens nowhere");
        const bool has_agent = one.agent < saved_.agents.size();
        switch (one.kind) {
            case TaskKind::spread:
                return must(one.index < director_.shared.events.size(), "an event is unknown");
            case TaskKind::timetable:
                return must(one.index < saved_.timetable.size() && one.value >= 0 && one.value <= 1e15,
                            "a timetable has no such entry");
            case TaskKind::set:
                if (one.agent == none) return must(one.index < saved_.crowd.size(), "a variable is unknown");
                return must(has_agent, "a task is for no agent");
            case TaskKind::view:
            case TaskKind::begin:
                return must(has_agent, "a task is for no agent");
            case TaskKind::event:
                return must(has_agent && one.index < director_.shared.events.size(), "an event is for no agent");
            default:
                must(has_agent, "a task is for no agent");
                of_level(one, saved_.agents[one.agent], machine_of(one.agent));
        }
    }

    // A task of a state: of the one that its agent is in, unless it has become pointless.
    static void of_level(const Task &one, const Agent &agent, const Machine &machine)
    {
        if (one.serial == 0) return must(one.kind == TaskKind::check, "a task is of no state");
        if (one.level >= agent.depth || agent.path[one.level].serial != one.serial) return;
        const State &state = machine.states[agent.path[one.level].state];
        if (one.kind == TaskKind::repeat) return must(state.repeats, "a state repeats nothing");
        if (one.kind == TaskKind::check) return must(state.checks, "a state checks nothing");
        must(one.index >= state.transitions.first && one.index - state.transitions.first < state.transitions.count,
             "a transition is of another state");
        const Trigger wanted = one.kind == TaskKind::after      ? Trigger::after
                               : one.kind == TaskKind::clip_end ? Trigger::clip_end
                                                                : Trigger::marker;
        must(machine.transitions[one.index].trigger == wanted, "a transition waits for something else");
        must(wanted == Trigger::after ||
                 (agent.clip != none && machine.casts[agent.cast].durations_s[agent.clip] > 1e-4 &&
                  std::fabs(one.value) <= 1e12 && one.play_serial != 0),
             "a transition waits for no clip");
    }

    void mask(uint32_t machine, uint32_t cast, uint32_t mask) const
    {
        must(machine < director_.machines.size() && cast < director_.machines[machine]->casts.size() &&
                 mask < director_.machines[machine]->masks.size(),
             "a mask is unknown");
    }

    void command(const SavedCommand &one) const
    {
        const Command &command = one.command;
        must(command.agent < saved_.agents.size() && std::isfinite(command.at_s) && command.curve <= CLQ_CURVE_INERTIAL,
             "a command is for no agent");
        if (command.mask != none) mask(one.machine, command.cast, command.mask);
        must(one.machine == none || one.machine < director_.machines.size(), "a command is of no machine");
        const bool calls = command.kind == CommandKind::call;
        must(calls ? one.action < director_.actions.size() && director_.actions[one.action]->def.show
                   : one.action == none,
             "an action is unknown");
        must(one.track.empty() == (command.kind != CommandKind::follow), "a command has no track");
        must(one.track.empty() || locomotion_of(command.agent), "an actor walks that cannot");
    }

    const SavedStage &saved_;
    const Director &director_;
};

}  // namespace

void check_saved(const SavedStage &saved, const Director &director) { Check(saved, director).all(); }

}  // namespace claque::stage
