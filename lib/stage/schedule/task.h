// A task: what wakes an agent, or the stage, at a time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lib/stage/machine/expression.h"

namespace claque::stage
{

enum class TaskKind : uint8_t {
    // Of the stage: at the beginning of a tick, before its budget.
    spread,     // an event looks for those that get it
    timetable,  // an entry is due
    set,        // a variable is set from outside
    view,       // an agent came into view or left it
    // Of one agent.
    begin,
    event,
    after,
    clip_end,
    marker,
    repeat,
    check
};

struct Task {
    double due_s = 0;
    uint64_t order = 0;     // decides between tasks of one time
    uint32_t agent = none;  // that is woken, or whose variable it is
    TaskKind kind = TaskKind::event;
    uint8_t priority = 0;
    uint8_t level = 0;         // of the agent's states; after ... check hold while its entry has this serial
    uint8_t has_place = 0;     // an event happened somewhere
    uint32_t serial = 0;       // of arrivals: the request
    uint32_t play_serial = 0;  // clip_end, marker: of the clip
    uint32_t index = 0;        // event, transition, entry or variable
    uint32_t sender = none;
    uint32_t agent_class = none;
    double value = 0;  // clip_end, marker: when it is
    double radius_m = 0, per_m_s = 0;
    double place[3] = {};
};

// How many tasks, and how many messages, may wait: agents that answer each event by several would take all memory.
constexpr size_t most_waiting(size_t agents) { return (size_t(1) << 20) + 64 * agents; }

inline bool is_of_stage(TaskKind kind) { return kind <= TaskKind::view; }

// Tasks from outside come before others of their time, in the order of their contents, so neither the threads that sent
// them nor the moment of sending matters. Orders of the stage's own tasks have the highest bit.
uint64_t order_of_message(const Task &task);
constexpr uint64_t own_order = uint64_t(1) << 63;

}  // namespace claque::stage
