// The scheduler's tasks, out and in.
#include <algorithm>

#include "lib/stage/save/fields.h"

namespace claque::stage
{

void Scheduler::save(SavedStage &out, const Worker &worker) const
{
    std::vector<Key> keys = heap_;
    std::sort(keys.begin(), keys.end(), [](const Key &a, const Key &b) { return Later()(b, a); });
    for (const Key &key : keys)
        if (is_of_stage(tasks_[key.slot].kind) || worker.is_alive(tasks_[key.slot]))
            out.waiting.push_back(tasks_[key.slot]);
    for (uint32_t c = 0; c < class_count; ++c) {
        const Queue &queue = queues_[c];
        for (size_t i = queue.first; i < queue.slots.size(); ++i)
            if (worker.is_alive(tasks_[queue.slots[i]])) out.queues[c].tasks.push_back(tasks_[queue.slots[i]]);
        out.queues[c].credit = queue.credit;
        out.queues[c].owed_since = queue.owed_since;
    }
    out.done = done;
    out.next_order = next_order_;
    out.scheduler_tick = tick_;
    out.unit_us = unit_us_;
}

void Scheduler::restore(const SavedStage &from)
{
    size_t count = from.waiting.size();
    for (const SavedQueue &queue : from.queues) count += queue.tasks.size();
    reserve(count);
    for (const Task &task : from.waiting) put(task);
    for (uint32_t c = 0; c < class_count; ++c) {
        Queue &queue = queues_[c];
        for (const Task &task : from.queues[c].tasks) {
            queue.slots.push_back(static_cast<uint32_t>(tasks_.size()));
            tasks_.push_back(task);
        }
        queue.credit = from.queues[c].credit;
        queue.owed_since = from.queues[c].owed_since;
    }
    done = from.done;
    next_order_ = from.next_order;
    tick_ = from.scheduler_tick;
    unit_us_ = from.unit_us;
}

void Director::restore(SavedStage &&saved, Scheduler &&tasks, Neighbours &&places, std::vector<Command> &commands_left)
{
    std::vector<uint32_t> machines_of;
    for (const Agent &agent : saved.agents) machines_of.push_back(agent.is_removed ? none : agent.machine);
    Vocabulary with = shared;
    with.classes = saved.classes;
    Vocabulary copy = with;
    const double decided = time_of(saved.tick);
    if (movement) movement->restore(saved.movement.data(), saved.movement.size());
    // Nothing below throws.
    inbox.replace(
        [&](Inbox::Directory &directory) {
            directory.shared = std::move(copy);
            directory.machine_of_agent.swap(machines_of);
        },
        saved.messages);
    shared = std::move(with);
    crowd.swap(saved.crowd);
    agents.swap(saved.agents);
    timetable.swap(saved.timetable);
    scheduler = std::move(tasks);
    neighbours = std::move(places);
    commands.clear();
    messages_.clear();
    phase_ = Phase::messages;
    tick = saved.tick, crowd_changed = saved.crowd_changed;
    transitions = saved.transitions, events = saved.events, command_count = saved.command_count;
    late_messages = saved.late_messages, runaways = saved.runaways, hash = saved.hash;
    live_agents = 0;
    for (const Agent &agent : agents) live_agents += !agent.is_removed;
    handover.replace(commands_left, decided);
}

}  // namespace claque::stage
