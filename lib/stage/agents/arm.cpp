// What the states of an agent wait for becomes tasks, once, when they are entered or when a clip begins.
#include <algorithm>
#include <cmath>

#include "lib/stage/agents/runner.h"

namespace claque::stage
{

namespace
{

constexpr uint8_t by_clip = 1, by_time = 2;
constexpr double least_wait_s = 0.001;

}  // namespace

Task Runner::of_level(TaskKind kind, uint32_t level, uint32_t index, double due_s) const
{
    Task task;
    task.kind = kind;
    task.agent = index_;
    task.priority = kind == TaskKind::clip_end || kind == TaskKind::marker ? by_clip : by_time;
    task.level = static_cast<uint8_t>(level);
    task.serial = agent_.path[level].serial;
    task.index = index;
    task.due_s = std::max(due_s, now_s_ + least_wait_s);
    return task;
}

void Runner::wait(uint32_t level)
{
    const State &state = machine_.states[agent_.path[level].state];
    for (uint32_t i = state.transitions.first; i < state.transitions.first + state.transitions.count; ++i) {
        if (machine_.transitions[i].trigger != Trigger::after) continue;
        Situation at = situation(now_s_);
        out_.tasks.push_back(of_level(TaskKind::after, level, i, now_s_ + amount(machine_.transitions[i].delay, at)));
    }
    if (state.repeats) post_repeat(level);
    if (state.checks) post_check(level);
}

void Runner::post_repeat(uint32_t level)
{
    const State &state = machine_.states[agent_.path[level].state];
    Situation at = situation(agent_.path[level].entered_s);
    out_.tasks.push_back(of_level(TaskKind::repeat, level, 0, now_s_ + amount(state.repeat_every, at)));
}

void Runner::post_check(uint32_t level)
{
    const State &state = machine_.states[agent_.path[level].state];
    out_.tasks.push_back(of_level(TaskKind::check, level, 0, now_s_ + state.check_s));
}

// Posts the tasks of transitions that wait for the clip and do not yet wait for this one.
void Runner::arm_clips()
{
    if (agent_.clip == none) return;
    if (!(machine_.casts[agent_.cast].durations_s[agent_.clip] > 1e-6 * agent_.play_speed)) return;
    for (uint32_t level = 0; level < agent_.depth; ++level) {
        if (agent_.path[level].armed_for == agent_.play_serial) continue;
        agent_.path[level].armed_for = agent_.play_serial;
        const Range all = machine_.states[agent_.path[level].state].transitions;
        for (uint32_t i = all.first; i < all.first + all.count; ++i) {
            const Trigger trigger = machine_.transitions[i].trigger;
            if (trigger == Trigger::clip_end || trigger == Trigger::marker) post_clip(i, level, now_s_);
        }
    }
}

// The first time after another one at which the clip stands at clip_s of a loop. A play does not stand there before its
// beginning.
double Runner::clip_time(double clip_s, double after_s) const
{
    const double duration_s = machine_.casts[agent_.cast].durations_s[agent_.clip];
    const double stands_s = agent_.play_phase_s + agent_.play_speed * (after_s - agent_.play_start_s);
    double loop = std::floor((stands_s - clip_s) / duration_s) + 1;
    for (;; ++loop) {
        const double at_s =
            agent_.play_start_s + (loop * duration_s + clip_s - agent_.play_phase_s) / agent_.play_speed;
        if (at_s > after_s) return at_s;
    }
}

// Posts the next end of a loop, or the next marker, after a time.
void Runner::post_clip(uint32_t transition, uint32_t level, double after_s)
{
    const Transition &waits = machine_.transitions[transition];
    double next_s = INFINITY, before_s = 0;
    if (waits.trigger == Trigger::marker) {
        for (const MarkerTime &one : machine_.casts[agent_.cast].markers)
            if (one.clip == agent_.clip && one.marker == waits.marker)
                next_s = std::min(next_s, clip_time(one.time_s, after_s));
    } else {
        Situation at = situation(agent_.path[level].entered_s);
        before_s = amount(waits.delay, at);
        next_s = clip_time(0, after_s);
    }
    if (next_s == INFINITY) return;
    const TaskKind kind = waits.trigger == Trigger::marker ? TaskKind::marker : TaskKind::clip_end;
    Task task = of_level(kind, level, transition, next_s - before_s);
    task.play_serial = agent_.play_serial;
    task.value = next_s;
    out_.tasks.push_back(task);
}

}  // namespace claque::stage
