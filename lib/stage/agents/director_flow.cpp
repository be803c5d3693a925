// What a tick hands on, and what changes between ticks.
#include <algorithm>
#include <cmath>

#include "lib/stage/agents/director.h"
#include "lib/stage/error.h"
#include "lib/stage/hash.h"

namespace claque::stage
{

namespace
{

constexpr float to_gait_s = 0.4f;

}  // namespace

// Pieces of tracks become commands, arrivals events. What has been taken is removed, so this can be repeated.
void Director::take_moved()
{
    commands.reserve(commands.size() + 3 * moved_.pieces.size());
    for (const Piece &piece : moved_.pieces) {
        Command command;
        command.at_s = piece.from_s;
        command.agent = piece.agent;
        command.kind = piece.track ? CommandKind::follow : CommandKind::leave;
        command.actor = agents[piece.agent].actor;
        command.track = piece.track;
        command.start_s = piece.start_s;
        command.order = static_cast<uint32_t>(commands.size());
        commands.push_back(command);
        if (piece.rises) play_on(piece);
    }
    moved_.pieces.clear();
    make_room(moved_.arrivals.size(), "arrivals", "");
    for (const Arrival &arrival : moved_.arrivals) {
        Task event;
        event.due_s = std::max(arrival.time_s, after_s());
        event.agent = arrival.agent;
        event.index = arrival.reached ? event_arrived : event_blocked;
        event.priority = shared.events[event.index].priority;
        event.serial = static_cast<uint32_t>(arrival.request);
        scheduler.add(event);
    }
    moved_.arrivals.clear();
    if (!movement) return;
    for (uint32_t i = 0; i < agents.size(); ++i) {
        Agent &agent = agents[i];
        if (!agent.is_walker || agent.is_removed) continue;
        const Place place = movement->place(i, end_s());
        neighbours.place(i, agent.agent_class, place.position);
        std::copy(place.position, place.position + 3, agent.position);
    }
}

// An agent that had settled played a clip, which its track would cut off: it goes on and fades to the gait.
void Director::play_on(const Piece &piece)
{
    Agent &agent = agents[piece.agent];
    if (agent.clip == none) return;
    Command command;
    command.at_s = piece.from_s;
    command.agent = piece.agent;
    command.kind = CommandKind::play;
    command.actor = agent.actor;
    command.clip = machines[agent.machine]->casts[agent.cast].clips[agent.clip];
    command.speed = static_cast<float>(agent.play_speed);
    command.phase_s = static_cast<float>(agent.play_phase_s + (piece.from_s - agent.play_start_s) * agent.play_speed);
    command.order = static_cast<uint32_t>(commands.size());
    commands.push_back(command);
    command.kind = CommandKind::walk_on;
    command.fade_s = to_gait_s;
    command.order = static_cast<uint32_t>(commands.size());
    commands.push_back(command);
    agent.clip = none, ++agent.play_serial;
}

// Orders the tick's commands by time. Keys are sorted and not commands, which are large.
void Director::publish()
{
    keys_.clear();
    for (const Command &command : commands) keys_.push_back({command.at_s, command.order});
    std::sort(keys_.begin(), keys_.end());
    ordered_.clear();
    ordered_.reserve(keys_.size());
    uint64_t with_these = hash;
    for (const auto &[at_s, order] : keys_) {
        ordered_.push_back(commands[order]);
        with_these = sum(with_these, ordered_.back());
    }
    if (const size_t held = handover.held(), most = most_commands(agents.size()); held + ordered_.size() > most)
        fail(CLQ_LIMIT,
             "%zu commands wait for clq_stage_apply, and the tick up to %g s has %zu more: %zu may wait, 2^20 and 4096 "
             "for each agent",
             held, end_s(), ordered_.size(), most);
    handover.publish(ordered_, end_s());
    hash = with_these;
    command_count += commands.size();
    commands.clear();
    ++tick;
}

uint32_t Director::add_agent(Agent &&agent, const std::string &agent_class, double start_s)
{
    const auto index = static_cast<uint32_t>(agents.size());
    std::string name = agent_class;
    uint32_t of_class = shared.find_class(agent_class);
    const bool is_new = of_class == none;
    if (is_new) {
        of_class = static_cast<uint32_t>(shared.classes.size());
        shared.classes.reserve(shared.classes.size() + 1);
    }
    agent.agent_class = of_class;
    agents.reserve(index + 1 > agents.capacity() ? 2 * size_t(index) + 16 : 0);
    make_room(1, "an agent", "");
    inbox.change([&](Inbox::Directory &directory) {
        directory.machine_of_agent.reserve(index + 1 > directory.machine_of_agent.capacity() ? 2 * index + 16 : 0);
        if (is_new) directory.shared.classes.push_back(agent_class);
        directory.machine_of_agent.push_back(agent.machine);
    });
    const bool walks = agent.is_walker;
    try {
        neighbours.place(index, of_class, agent.position);
        if (walks) {
            Walker walker;
            walker.locomotion = machines[agent.machine]->casts[agent.cast].locomotion;
            walker.seed = stage::hash(def.seed, agent.seed, 1, 0);
            std::copy(agent.position, agent.position + 3, walker.position);
            walker.heading_rad = agent.heading_rad;
            walker.scale = agent.scale;
            movement->add(index, walker, std::max(start_s, decided_s()));
        }
    } catch (...) {
        neighbours.remove(index);
        inbox.change([&](Inbox::Directory &directory) {
            directory.machine_of_agent.pop_back();
            if (is_new) directory.shared.classes.pop_back();
        });
        throw;
    }
    agents.push_back(std::move(agent));
    if (is_new) shared.classes.push_back(std::move(name));
    Task begin;
    begin.kind = TaskKind::begin;
    begin.agent = index;
    begin.due_s = start_s;
    begin.priority = 1;
    scheduler.add(begin);
    ++live_agents;
    return index;
}

void Director::remove_agent(uint32_t index)
{
    Agent &agent = agents[index];
    if (agent.is_walker) movement->remove(index, decided_s());
    inbox.change([&](Inbox::Directory &directory) { directory.machine_of_agent[index] = none; });
    neighbours.remove(index);
    agent.is_removed = true;
    agent.depth = 0;
    --live_agents;
}

void Director::set_place(uint32_t index, const double position[3])
{
    Agent &agent = agents[index];
    if (agent.is_walker) fail(CLQ_ARGUMENT, "agent %u walks: its place is where its way has led it", index + 1);
    neighbours.place(index, agent.agent_class, position);
    std::copy(position, position + 3, agent.position);
}

void Director::add_machine(std::unique_ptr<Machine> machine, Vocabulary &&with)
{
    std::vector<double> values = crowd;
    for (size_t i = crowd.size(); i < with.crowd.size(); ++i) values.push_back(with.crowd[i].initial);
    machines.reserve(machines.size() + 1);
    Vocabulary copy = with;
    inbox.change([&](Inbox::Directory &directory) {
        directory.machines.push_back(machine.get());
        directory.shared = std::move(copy);
    });
    shared = std::move(with);
    crowd.swap(values);
    machines.push_back(std::move(machine));
}

void Director::add_action(std::unique_ptr<HostAction> action)
{
    Vocabulary with = shared;
    with.actions.push_back(action->name);
    actions.reserve(actions.size() + 1);
    shared = std::move(with);
    actions.push_back(std::move(action));
}

void Director::add_entries(std::vector<Entry> &&entries)
{
    timetable.reserve(timetable.size() + entries.size());
    make_room(entries.size(), "a timetable", "");
    for (Entry &entry : entries) {
        Task task;
        task.kind = TaskKind::timetable;
        task.index = static_cast<uint32_t>(timetable.size());
        task.due_s = entry.task.due_s;
        scheduler.add(task);
        timetable.push_back(entry);
    }
}

clq_stage_info Director::info() const
{
    clq_stage_info out = clq_stage_info_init();
    out.agents = live_agents;
    out.machines = static_cast<uint32_t>(machines.size());
    out.decided_s = decided_s();
    out.ticks = tick;
    out.transitions = transitions;
    out.events = events;
    out.commands = command_count;
    out.late_messages = late_messages;
    out.runaways = runaways;
    out.tasks = scheduler.waiting();
    out.hash = hash;
    std::copy(scheduler.done.begin(), scheduler.done.end(), out.classes);
    return out;
}

}  // namespace claque::stage
