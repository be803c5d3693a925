#include "lib/stage/agents/runner.h"

#include <algorithm>
#include <cmath>

namespace claque::stage
{

void Outcome::clear(const std::vector<double> &crowd_before)
{
    commands.clear(), tasks.clear(), calls.clear();
    crowd = crowd_before;
    crowd_changed = 0;
    goes = stops = ran_away = false;
}

void Runner::run(const Task &task, double now_s)
{
    now_s_ = agent_.now_s = std::max(now_s, agent_.now_s);
    switch (task.kind) {
        case TaskKind::begin:
            begin();
            break;
        case TaskKind::event:
            get(task);
            break;
        case TaskKind::after:
            if (holds(machine_.transitions[task.index], task.level)) take(machine_.transitions[task.index], task.level);
            break;
        case TaskKind::clip_end:
        case TaskKind::marker:
            post_clip(task.index, task.level, std::max(task.value, now_s_));
            if (holds(machine_.transitions[task.index], task.level)) take(machine_.transitions[task.index], task.level);
            break;
        case TaskKind::repeat:
            post_repeat(task.level);
            act(machine_.states[agent_.path[task.level].state].repeat, agent_.path[task.level]);
            break;
        default:
            if (task.level < agent_.depth && task.serial) post_check(task.level);
    }
    settle();
    arm_clips();
}

// An event that no transition takes is forgotten, with its value and origin.
void Runner::get(const Task &event)
{
    const double value = agent_.value, origin[3] = {agent_.origin[0], agent_.origin[1], agent_.origin[2]};
    const uint32_t sender = agent_.sender;
    const bool has_origin = agent_.has_origin;
    agent_.value = event.value;
    agent_.sender = event.sender;
    agent_.has_origin = event.has_place;
    std::copy(event.place, event.place + 3, agent_.origin);
    if (event.index == event_arrived || event.index == event_blocked) agent_.walking = false;
    if (take_first(Trigger::event, event.index)) return;
    agent_.value = value, agent_.sender = sender, agent_.has_origin = has_origin;
    std::copy(origin, origin + 3, agent_.origin);
}

void Runner::begin()
{
    agent_.depth = 0;
    agent_.last.assign(machine_.states.size(), none);
    agent_.variables.clear();
    for (const Variable &variable : machine_.variables) agent_.variables.push_back(variable.initial);
    enter(machine_.initial, History::none);
}

bool Runner::holds(const Transition &transition, uint32_t level)
{
    if (!transition.guard) return true;
    Situation at = situation(agent_.path[level].entered_s);
    return evaluate(machine_.ops.data(), transition.guard, at) != 0;
}

// Takes the first transition that applies, from the innermost state outwards.
bool Runner::take_first(Trigger trigger, uint32_t event)
{
    for (uint32_t level = agent_.depth; level-- > 0;) {
        const Range all = machine_.states[agent_.path[level].state].transitions;
        for (uint32_t i = all.first; i < all.first + all.count; ++i) {
            const Transition &transition = machine_.transitions[i];
            if (transition.trigger != trigger || transition.event != event || !holds(transition, level)) continue;
            take(transition, level);
            return true;
        }
    }
    return false;
}

void Runner::settle()
{
    for (uint32_t i = 0; i < max_instant_transitions; ++i)
        if (!take_first(Trigger::instant, none)) return;
    out_.ran_away = true;
}

uint32_t Runner::chosen_target(const Transition &transition)
{
    const Target *all = &machine_.targets[transition.targets.first];
    if (transition.targets.count == 1) return all[0].state;
    double total = 0;
    for (uint32_t i = 0; i < transition.targets.count; ++i) total += all[i].weight;
    Situation at = situation(now_s_);
    double left = draw(at, transition.purpose) * total;
    uint32_t chosen = 0;
    for (uint32_t i = 0; i < transition.targets.count && left >= 0; ++i) {
        if (all[i].weight > 0) chosen = i;
        left -= all[i].weight;
    }
    return all[chosen].state;
}

// The number of states, from the outermost in, that a transition does not leave.
uint32_t Runner::depth_to_keep(uint32_t source, uint32_t target) const
{
    const std::vector<State> &states = machine_.states;
    uint32_t a = source, b = target;
    while (states[b].depth > states[a].depth) b = states[b].parent;
    if (a == b && source != target) return states[source].depth;  // to a state within
    while (states[a].depth > states[b].depth) a = states[a].parent;
    if (a == target) return states[target].depth - 1;  // itself, or a state round it: entered again
    while (a != b) {
        a = states[a].parent;
        b = states[b].parent;
    }
    return a == none ? 0 : states[a].depth;
}

void Runner::take(const Transition &transition, uint32_t level)
{
    const Level source = agent_.path[level];
    ++agent_.transitions;
    if (transition.targets.count == 0) {
        act(transition.actions, source);
        return;
    }
    const uint32_t target = chosen_target(transition);
    leave(depth_to_keep(transition.source, target));
    act(transition.actions, source);
    enter(target, transition.history);
}

void Runner::leave(uint32_t depth)
{
    while (agent_.depth > depth) {
        const Level level = agent_.path[agent_.depth - 1];
        const State &state = machine_.states[level.state];
        if (state.parent != none) agent_.last[state.parent] = level.state;
        act(state.leave, level);
        --agent_.depth;
    }
}

void Runner::enter(uint32_t target, History history)
{
    uint32_t way[max_depth], count = 0;
    for (uint32_t state = target; machine_.states[state].depth > agent_.depth; state = machine_.states[state].parent) {
        way[count++] = state;
        if (machine_.states[state].parent == none) break;
    }
    while (count > 0) enter_one(way[--count]);
    uint32_t state = target;
    while (machine_.states[state].initial != none) {
        const uint32_t last = history == History::none ? none : agent_.last[state];
        state = last == none ? machine_.states[state].initial : last;
        if (history == History::shallow) history = History::none;
        enter_one(state);
    }
}

void Runner::enter_one(uint32_t state)
{
    const uint32_t level = agent_.depth++;
    agent_.path[level] = {state, agent_.next_serial++, 0, now_s_};
    act(machine_.states[state].enter, agent_.path[level]);
    wait(level);
}

double Runner::nearest_m(uint32_t agent_class)
{
    return around_.neighbours->nearest(agent_.position, agent_class, index_).distance_m;
}

double Runner::count(uint32_t agent_class, double radius_m)
{
    std::vector<Neighbours::Found> found;
    around_.neighbours->within(agent_.position, std::clamp(radius_m, 0.0, Neighbours::reach_m), agent_class, found);
    const auto own = [this](const Neighbours::Found &one) { return one.agent == index_; };
    return static_cast<double>(found.size()) - (std::any_of(found.begin(), found.end(), own) ? 1 : 0);
}

}  // namespace claque::stage
