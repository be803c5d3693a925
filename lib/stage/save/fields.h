// The fields of a saved stage, each once for both directions.
#pragma once

#include "lib/stage/agents/director.h"
#include "lib/stage/flow/shown.h"
#include "lib/stage/save/archive.h"

namespace claque::stage
{

constexpr size_t least_task = 92, least_agent = 190, least_command = 140;

template <class Archive>
void fields(Archive &archive, Task &task)
{
    numbers(archive, task.due_s, task.order, task.agent);
    number_of_enum(archive, task.kind, TaskKind::check);
    numbers(archive, task.priority, task.level, task.has_place, task.serial, task.play_serial, task.index, task.sender,
            task.agent_class, task.value, task.radius_m, task.per_m_s, task.place[0], task.place[1], task.place[2]);
}

template <class Archive>
void fields(Archive &archive, Level &level)
{
    numbers(archive, level.state, level.serial, level.armed_for, level.entered_s);
}

template <class Archive>
void fields(Archive &archive, Agent &agent)
{
    numbers(archive, agent.actor.index1, agent.actor.generation, agent.machine, agent.cast, agent.agent_class,
            agent.seed, agent.gaze.index1, agent.scale, agent.heading_rad, agent.is_walker);
    numbers(archive, agent.is_removed, agent.in_view, agent.walking, agent.has_origin, agent.depth);
    if (agent.depth > max_depth) bad_save("an agent is in too many states");
    for (uint32_t i = 0; i < agent.depth; ++i) fields(archive, agent.path[i]);
    numbers(archive, agent.next_serial, agent.draws, agent.request, agent.sender, agent.play_serial, agent.clip,
            agent.play_start_s, agent.play_phase_s, agent.play_speed, agent.now_s, agent.value, agent.transitions);
    for (int k = 0; k < 3; ++k) numbers(archive, agent.origin[k], agent.position[k]);
    list(archive, agent.variables, 8, [&](double &value) { archive.number(value); });
    list(archive, agent.last, 4, [&](uint32_t &state) { archive.number(state); });
}

template <class Archive>
void fields(Archive &archive, Entry &entry)
{
    fields(archive, entry.task);
    numbers(archive, entry.every_s, entry.times);
}

// What a command points at is saved by number: machine and action here, the track beside it.
struct SavedCommand {
    Command command;
    uint32_t machine = none, action = none;
    std::vector<uint8_t> track;
};

template <class Archive>
void fields(Archive &archive, SavedCommand &saved)
{
    Command &command = saved.command;
    numbers(archive, command.at_s, command.order, command.agent);
    number_of_enum(archive, command.kind, CommandKind::call);
    numbers(archive, command.adds, command.curve, command.actor.index1, command.actor.generation, command.clip,
            command.speed, command.phase_s, command.weight, command.loops, command.fade_s, command.fade_out_s,
            command.gaze.index1, command.cast, command.mask, command.value, command.start_s, command.point[0],
            command.point[1], command.point[2]);
    numbers(archive, saved.machine, saved.action);
    list(archive, saved.track, 1, [](uint8_t &) {});
    archive.raw(saved.track);
}

struct SavedRow {
    uint32_t gestures[Shown::max_gestures] = {};
    std::vector<uint8_t> tracks[CLQ_TRACK_PIECES];
};

template <class Archive>
void fields(Archive &archive, SavedRow &row)
{
    for (uint32_t &gesture : row.gestures) archive.number(gesture);
    for (std::vector<uint8_t> &track : row.tracks) {
        list(archive, track, 1, [](uint8_t &) {});
        archive.raw(track);
    }
}

struct SavedMask {
    uint32_t machine = 0, cast = 0, mask = 0, made = 0;
};

template <class Archive>
void fields(Archive &archive, SavedMask &mask)
{
    numbers(archive, mask.machine, mask.cast, mask.mask, mask.made);
}

struct SavedQueue {
    std::vector<Task> tasks;
    double credit = 0;
    uint64_t owed_since = 0;
};

// The whole of it.
struct SavedStage {
    uint64_t made_of = 0;  // settings, machines and actions
    std::vector<std::string> classes;
    std::vector<double> crowd;
    std::vector<Agent> agents;
    std::vector<Entry> timetable;
    std::vector<Task> waiting, messages;
    std::array<SavedQueue, class_count> queues;
    std::array<clq_stage_class_info, class_count> done{};
    uint64_t next_order = 0, scheduler_tick = 0;
    double unit_us = 1;
    uint64_t tick = 0, crowd_changed = 0, transitions = 0, events = 0, command_count = 0, late_messages = 0,
             runaways = 0, hash = 0;
    std::vector<SavedCommand> commands;
    std::vector<SavedRow> rows;
    std::vector<SavedMask> masks;
    double shown_s = 0;
    std::vector<uint8_t> movement;
};

template <class Archive>
void fields(Archive &archive, SavedStage &all)
{
    const auto each = [&](auto &one) { fields(archive, one); };
    archive.number(all.made_of);
    list(archive, all.classes, 8, [&](std::string &name) { text(archive, name); });
    list(archive, all.crowd, 8, [&](double &value) { archive.number(value); });
    list(archive, all.agents, least_agent, each);
    list(archive, all.timetable, least_task, each);
    list(archive, all.waiting, least_task, each);
    list(archive, all.messages, least_task, each);
    for (SavedQueue &queue : all.queues) {
        list(archive, queue.tasks, least_task, each);
        numbers(archive, queue.credit, queue.owed_since);
    }
    for (clq_stage_class_info &one : all.done)
        numbers(archive, one.done, one.late, one.longest_wait_s, one.cost, one.waiting);
    numbers(archive, all.next_order, all.scheduler_tick, all.unit_us, all.tick, all.crowd_changed, all.transitions,
            all.events, all.command_count, all.late_messages, all.runaways, all.hash);
    list(archive, all.commands, least_command, each);
    list(archive, all.rows, 48, each);
    list(archive, all.masks, 16, each);
    archive.number(all.shown_s);
    list(archive, all.movement, 1, [](uint8_t &) {});
    archive.raw(all.movement);
}

// A hash of what a stage is made of; a saved stage fits only one of the same.
uint64_t hash_of_parts(const Director &director);

SavedStage snapshot(const Director &director, const Shown &shown);

// Refuses what no stage can hold.
void check_saved(const SavedStage &saved, const Director &director);

// Puts it in place. If it throws, nothing has changed but that the crowd may know more tracks.
void put_back(SavedStage &&saved, Director &director, Shown &shown, clq_crowd *crowd);

}  // namespace claque::stage
