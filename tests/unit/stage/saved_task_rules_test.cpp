// What tasks and commands of a saved stage may hold, on both sides of each bound.
#include "tests/unit/stage/saved_rules.h"

using namespace saved_rules;

TEST_F(SavedRules, OfATask)
{
    good_.waiting = {task(TaskKind::event)}, good_.messages = {task(TaskKind::set)};
    good_.queues[1].tasks = {task(TaskKind::begin)};
    TAKES([](SavedStage &) {});
    RANGE("a task is never due", s.waiting[0].due_s, {1e15, -1e15}, {1.001e15, -1.001e15, NAN});
    RANGE("a task is never due", s.messages[0].due_s, {0}, {INFINITY});
    RANGE("a task is never due", s.queues[1].tasks[0].due_s, {0}, {INFINITY});
    RANGE("a task has no class", s.waiting[0].priority, {class_count - 1}, {class_count});
    RANGE("a task has no class", s.waiting[0].has_place, {0, 1}, {2});
    RANGE("an event has no sender", s.waiting[0].sender, {2, none}, {3});
    RANGE("an event is for an unknown class", s.waiting[0].agent_class, {1, none}, {2});
    RANGE("an event has no reach", s.waiting[0].radius_m, {0, 1e30}, {-1e-9, 1.001e30, NAN});
    RANGE("an event has no reach", s.waiting[0].per_m_s, {0, 1e7}, {-1e-9, 1.001e7, NAN});
    for (int k = 0; k < 3; ++k) {
        RANGE("an event happens nowhere", (s.waiting[0].has_place = 1, s.waiting[0].place[k]), places, nowhere);
        RANGE("", s.waiting[0].place[k], nowhere, {});
    }
    RANGE("an event is for no agent", s.waiting[0].index, {4}, {5});
    RANGE("an event is for no agent", s.waiting[0].agent, {2}, {3, none});
    for (const TaskKind kind : {TaskKind::spread, TaskKind::timetable, TaskKind::set, TaskKind::view}) {
        TAKES(waiting(task(kind)));
        REFUSES("a task of the stage has a class", [&](SavedStage &s) { s.queues[0].tasks = {task(kind)}; });
    }
    const auto of = [](SavedStage &s, TaskKind kind) -> Task & { return s.waiting[0].kind = kind, s.waiting[0]; };
    RANGE("an event is unknown", of(s, TaskKind::spread).index, {4}, {5});
    RANGE("", of(s, TaskKind::spread).agent, {3, none}, {});
    RANGE("a timetable has no such entry", of(s, TaskKind::timetable).index, {0}, {1});
    RANGE("a timetable has no such entry", of(s, TaskKind::timetable).value, {0, 1e15}, {-1, 1.001e15, NAN});
    RANGE("a task is for no agent", of(s, TaskKind::set).agent, {2, none}, {3});
    good_.waiting[0].index = 1;
    REFUSES("a variable is unknown", [&](SavedStage &s) { of(s, TaskKind::set).agent = none; });
    RANGE("a task is for no agent", of(s, TaskKind::view).agent, {2}, {3, none});
    RANGE("a task is for no agent", of(s, TaskKind::begin).agent, {2}, {3, none});
    RANGE("a task is for no agent", of(s, TaskKind::check).agent, {2}, {3, none});
}

TEST_F(SavedRules, OfATaskOfAState)
{
    TAKES(waiting(task(TaskKind::check)));
    for (const TaskKind kind : {TaskKind::after, TaskKind::clip_end, TaskKind::marker, TaskKind::repeat})
        REFUSES("a task is of no state", waiting(task(kind)));
    const Task after = of_level(TaskKind::after, 0, Trigger::after),
               end = of_level(TaskKind::clip_end, 1, Trigger::clip_end),
               marker = of_level(TaskKind::marker, 1, Trigger::marker);
    for (const Task &one : {after, end, marker}) TAKES(waiting(one));
    for (const TaskKind kind : {TaskKind::repeat, TaskKind::check})
        for (const uint8_t level : {0, 1}) {
            Task one = of_level(kind, level, level ? Trigger::marker : Trigger::after);
            if (level) TAKES(waiting(one));
            else REFUSES(kind == TaskKind::repeat ? "a state repeats nothing" : "a state checks nothing", waiting(one));
            // Of a state that was left, it is pointless whatever it says.
            ++one.serial, one.index = 1000;
            TAKES(waiting(one));
            --one.serial, one.level = 2;
            TAKES(waiting(one));
        }
    Task other = after;
    for (other.index = 0; other.index < machine().transitions.size(); ++other.index)
        if (other.index != after.index) REFUSES("a transition is of another state", waiting(other));
    other = end, other.index = marker.index;
    REFUSES("a transition waits for something else", waiting(other));
    other = marker, other.index = end.index;
    REFUSES("a transition waits for something else", waiting(other));
    other = after, other.kind = TaskKind::marker;
    REFUSES("a transition waits for something else", waiting(other));

    const char *const no_clip = "a transition waits for no clip";
    good_.waiting = {end};
    RANGE(no_clip, s.waiting[0].value, {1e12, -1e12}, {1.001e12, -1.001e12, NAN});
    RANGE(no_clip, s.waiting[0].play_serial, {1}, {0});
    RANGE(no_clip, s.agents[0].clip, {double(good_.agents[0].clip)}, {none});
    double &length_s = cast().durations_s[good_.agents[0].clip];
    length_s = 1e-4;
    REFUSES(no_clip, [](SavedStage &) {});
    length_s = 1.001e-4;
    TAKES([](SavedStage &) {});
}

TEST_F(SavedRules, OfACommand)
{
    good_.commands.resize(1);
    RANGE("a command is for no agent", s.commands[0].command.agent, {0, 2}, {3});
    RANGE("a command is for no agent", s.commands[0].command.at_s, {-1e300}, {INFINITY, NAN});
    RANGE("a command is for no agent", s.commands[0].command.curve, {CLQ_CURVE_INERTIAL}, {CLQ_CURVE_INERTIAL + 1});
    RANGE("a command is of no machine", s.commands[0].machine, {0, none}, {1});
    const auto masked = [](uint32_t machine, uint32_t cast, uint32_t mask) {
        return [=](SavedStage &s) {
            s.commands[0].machine = machine, s.commands[0].command.cast = cast, s.commands[0].command.mask = mask;
        };
    };
    TAKES(masked(0, 0, 0));
    for (const auto &forge : {masked(none, 0, 0), masked(0, 1, 0), masked(0, 0, 1)})
        REFUSES("a mask is unknown", forge);
    SavedCommand call;
    call.command.kind = CommandKind::call, call.action = 0;
    TAKES(commanded(call));
    for (const uint32_t action : {1u, 2u, none}) {  // the second one decides alone
        call.action = action;
        REFUSES("an action is unknown", commanded(call));
    }
    REFUSES("an action is unknown", [](SavedStage &s) { s.commands[0].action = 0; });
    REFUSES("a command has no track", [](SavedStage &s) { s.commands[0].track = {1}; });
    SavedCommand follow;
    follow.command.kind = CommandKind::follow;
    REFUSES("a command has no track", commanded(follow));
    follow.track = {1};
    REFUSES("an actor walks that cannot", commanded(follow));
    give_locomotion();
    TAKES(commanded(follow));
}
