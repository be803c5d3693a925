#include <algorithm>
#include <cmath>

#include "lib/stage/agents/runner.h"

namespace claque::stage
{

namespace
{

constexpr double radians = 3.14159265358979323846 / 180;
constexpr double eyes_m = 1.5;  // of an agent, above its place

}  // namespace

Situation Runner::situation(double entered_s)
{
    Situation at;
    at.variables = agent_.variables.data();
    at.crowd = out_.crowd.data();
    at.time = now_s_ - entered_s;
    at.clock = now_s_;
    at.value = agent_.value;
    at.distance = agent_.has_origin ? around_.neighbours->distance_m(agent_.position, agent_.origin) : INFINITY;
    at.in_view = agent_.in_view;
    at.walking = agent_.walking;
    at.seed = around_.seed;
    at.agent_seed = agent_.seed;
    at.draws = &agent_.draws;
    at.nearby = this;
    return at;
}

double Runner::amount(const Quantity &quantity, Situation &at)
{
    if (quantity.program) {
        const double found = evaluate(machine_.ops.data(), quantity.program, at);
        return found >= quantity.least ? std::min(found, quantity.most) : quantity.least;  // what is no number, too
    }
    if (quantity.least == quantity.most) return quantity.least;
    return quantity.least + (quantity.most - quantity.least) * draw(at, quantity.purpose);
}

void Runner::act(Range actions, const Level &level)
{
    for (uint32_t i = 0; i < actions.count; ++i) {
        const Action &action = machine_.actions[actions.first + i];
        Situation at = situation(level.entered_s);
        if (!action.guard || evaluate(machine_.ops.data(), action.guard, at) != 0) act_one(action, at);
    }
}

void Runner::act_one(const Action &action, Situation &at)
{
    switch (action.verb) {
        case Verb::play:
            return play(action, at);
        case Verb::gesture:
            return gesture(action, at);
        case Verb::end_gesture:
        case Verb::walk_on: {
            Command made = command(action.verb == Verb::walk_on ? CommandKind::walk_on : CommandKind::end_gesture);
            made.fade_s = static_cast<float>(amount(action.fade, at));
            if (action.verb == Verb::walk_on) agent_.clip = none, ++agent_.play_serial;
            out_.commands.push_back(made);
            return;
        }
        case Verb::set:
            return set(action, at);
        case Verb::send:
            return send(action, at);
        case Verb::look:
            return look(action);
        case Verb::go:
            return go(action, at);
        case Verb::stop:
            out_.stops = true, out_.goes = false;
            agent_.walking = false;
            ++agent_.request;
            return;
        case Verb::call:
            return call(action, at);
    }
}

Command Runner::command(CommandKind kind) const
{
    Command made;
    made.at_s = now_s_;
    made.agent = index_;
    made.kind = kind;
    made.actor = agent_.actor;
    return made;
}

uint32_t Runner::chosen_clip(const Action &action, Situation &at)
{
    uint32_t chosen = 0;
    if (action.clips.count > 1) chosen = static_cast<uint32_t>(draw(at, action.purpose) * action.clips.count);
    return machine_.clip_choices[action.clips.first + chosen];
}

void Runner::play(const Action &action, Situation &at)
{
    agent_.clip = chosen_clip(action, at);
    ++agent_.play_serial;
    const Cast &cast = machine_.casts[agent_.cast];
    // Rounded as the crowd will have them, so that ends are where the crowd has them.
    const auto speed = static_cast<float>(amount(action.speed, at));
    const auto phase_s = static_cast<float>(amount(action.phase, at) * cast.durations_s[agent_.clip]);
    agent_.play_speed = static_cast<double>(speed);
    agent_.play_phase_s = static_cast<double>(phase_s);
    agent_.play_start_s = now_s_;
    Command made = command(CommandKind::fade);
    made.clip = cast.clips[agent_.clip];
    made.speed = speed, made.phase_s = phase_s;
    made.fade_s = static_cast<float>(amount(action.fade, at));
    made.curve = static_cast<uint8_t>(action.curve);
    if (made.fade_s == 0) made.kind = CommandKind::play;
    out_.commands.push_back(made);
}

void Runner::gesture(const Action &action, Situation &at)
{
    Command made = command(CommandKind::gesture);
    made.clip = machine_.casts[agent_.cast].clips[chosen_clip(action, at)];
    made.adds = action.adds;
    made.speed = static_cast<float>(amount(action.speed, at));
    made.loops = static_cast<float>(amount(action.loops, at));
    made.weight = static_cast<float>(amount(action.weight, at));
    made.fade_s = static_cast<float>(amount(action.fade, at));
    made.fade_out_s = static_cast<float>(amount(action.fade_out, at));
    made.curve = CLQ_CURVE_SMOOTH;
    made.machine = &machine_;
    made.cast = agent_.cast;
    made.mask = action.mask;
    out_.commands.push_back(made);
}

void Runner::set(const Action &action, Situation &at)
{
    const double value = evaluate(machine_.ops.data(), action.program, at);
    std::vector<double> &variables = action.of_crowd ? out_.crowd : agent_.variables;
    if (action.of_crowd && !(variables[action.variable] == value)) out_.crowd_changed |= uint64_t(1) << action.variable;
    variables[action.variable] = value == value ? value : NAN;  // which has one form only
}

void Runner::send(const Action &action, Situation &at)
{
    if (action.to == To::sender && agent_.sender == none) return;
    Task task;
    task.due_s = std::max(now_s_ + amount(action.delay, at), around_.not_before_s);
    task.kind = action.to == To::all ? TaskKind::spread : TaskKind::event;
    task.agent = action.to == To::self ? index_ : action.to == To::sender ? agent_.sender : none;
    task.index = action.variable;
    task.priority = around_.shared->events[action.variable].priority;
    task.sender = index_;
    task.agent_class = action.agent_class;
    task.value = amount(action.value, at);
    task.radius_m = amount(action.radius, at);
    task.per_m_s = amount(action.per_m, at);
    task.has_place = 1;
    std::copy(agent_.position, agent_.position + 3, task.place);
    out_.tasks.push_back(task);
}

void Runner::look(const Action &action)
{
    if (agent_.gaze.index1 == 0) return;
    Command made = command(CommandKind::look);
    made.gaze = agent_.gaze;
    std::copy(action.point, action.point + 3, made.point);
    if (action.aim == Aim::nothing) {
        made.kind = CommandKind::look_away;
    } else if (action.aim == Aim::sender) {
        if (!agent_.has_origin) return;
        std::copy(agent_.origin, agent_.origin + 3, made.point);
        made.point[1] += eyes_m / around_.metres_per_unit;
    } else if (action.aim == Aim::agent_class) {
        const double *found = around_.neighbours->nearest_place(agent_.position, action.agent_class, index_);
        if (!found) return;
        std::copy(found, found + 3, made.point);
        made.point[1] += eyes_m / around_.metres_per_unit;
    }
    out_.commands.push_back(made);
}

void Runner::go(const Action &action, Situation &at)
{
    if (!agent_.is_walker) return;
    const double *to = action.aim == Aim::sender ? agent_.origin : action.point;
    if (action.aim == Aim::sender && !agent_.has_origin) return;
    std::copy(to, to + 3, out_.goal.position);
    out_.goal.speed_m_s = static_cast<float>(amount(action.speed, at));
    out_.goal.near_m = static_cast<float>(amount(action.near_m, at));
    out_.goal.heading_rad = action.has_heading ? amount(action.heading_deg, at) * radians : NAN;
    out_.goal.settles = action.settles;
    out_.goal.request = ++agent_.request;
    out_.goes = true, out_.stops = false;
    agent_.walking = true;
}

void Runner::call(const Action &action, Situation &at)
{
    const HostAction *host = (*around_.actions)[action.variable].get();
    const double value = amount(action.value, at);
    if (host->def.decide) out_.calls.push_back({host, value});
    if (!host->def.show) return;
    Command made = command(CommandKind::call);
    made.action = host;
    made.value = value;
    out_.commands.push_back(made);
}

}  // namespace claque::stage
