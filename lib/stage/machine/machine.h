// A state machine as read from its file: plain tables, shared by all agents that run it.
#pragma once

#include <claque/play.h>
#include <claque/track.h>

#include <memory>
#include <string>
#include <vector>

#include "lib/stage/machine/expression.h"

namespace claque::stage
{

constexpr uint32_t max_depth = 8, max_states = 1000, max_transitions = 4000, max_actions = 8000, max_variables = 64,
                   max_events = 256, max_clips = 1000;

// A number, a random one between two, or an expression.
struct Quantity {
    double least = 0, most = 0;
    Program program;
    uint32_t purpose = 0;
};

struct Range {
    uint32_t first = 0, count = 0;
};

enum class Verb : uint8_t { play, gesture, end_gesture, walk_on, set, send, look, go, stop, call };
enum class To : uint8_t { self, sender, all };
enum class Aim : uint8_t { sender, nothing, agent_class, point };

struct Action {
    Verb verb = Verb::stop;
    Program guard;
    uint32_t purpose = 0;
    Range clips;                  // play, gesture: in Machine::clip_choices
    Quantity fade, speed, phase;  // play; gesture: its fade in
    Quantity fade_out, loops, weight;
    clq_curve curve = CLQ_CURVE_SMOOTH;
    bool adds = false;
    uint32_t mask = none;
    bool of_crowd = false;     // set
    uint32_t variable = none;  // set; send: the event; call: the action
    Program program;           // set
    To to = To::all;
    uint32_t agent_class = none;  // send, look
    Quantity radius, delay, value, per_m;
    Aim aim = Aim::point;  // look, go
    double point[3] = {};
    Quantity near_m;  // go
    bool has_heading = false, settles = false;
    Quantity heading_deg;
};

enum class Trigger : uint8_t { instant, event, after, clip_end, marker };
enum class History : uint8_t { none, shallow, deep };

struct Transition {
    uint32_t source = 0;
    Trigger trigger = Trigger::instant;
    uint32_t event = none;   // of the stage
    uint32_t marker = none;  // in Machine::marker_names
    Quantity delay;          // after; of clip_end the time before
    Program guard;
    Range targets;  // in Machine::targets; none: no state is left
    History history = History::none;
    Range actions;
    uint32_t purpose = 0, line = 0;
};

struct Target {
    uint32_t state = 0;
    double weight = 1;
};

struct State {
    std::string name;
    uint32_t parent = none, initial = none;  // initial: the child that is entered first
    uint32_t depth = 1;                      // of itself; 1: no state round it
    uint32_t cost = 0;                       // 0: of its parent
    Range enter, leave, repeat, transitions;
    Quantity repeat_every;  // while
    bool repeats = false;
    bool checks = false;  // a condition of its transitions changes by itself
    double check_s = 0;
    uint64_t crowd_reads = 0;  // variables of the crowd, by index, that its instant transitions read
    uint32_t line = 0;
};

struct Variable {
    std::string name;
    Type type = Type::number;
    double initial = 0;
};

struct Mask {
    std::string name;
    std::vector<std::string> nodes;
    uint32_t feather = 0;
    bool inverted = false;
};

struct MarkerTime {
    uint32_t clip = 0, marker = 0;  // as the machine counts them
    double time_s = 0;              // from the beginning of the clip
};

// A template that agents of the machine may have: what its clips and markers are there.
struct Cast {
    const clq_template *tmpl = nullptr;
    const clq_locomotion *locomotion = nullptr;
    std::vector<uint32_t> clips;  // the template's index, by the machine's
    std::vector<double> durations_s;
    std::vector<MarkerTime> markers;
};

struct Machine {
    std::string name;
    std::vector<Op> ops;
    std::vector<State> states;  // parents before children, in the order of the file
    std::vector<Transition> transitions;
    std::vector<Target> targets;
    std::vector<Action> actions;
    std::vector<uint32_t> clip_choices;
    std::vector<std::string> clip_names, marker_names;
    std::vector<Variable> variables;
    std::vector<Mask> masks;
    std::vector<Cast> casts;
    uint32_t initial = 0;
    bool goes = false;  // it has actions that walk
    uint64_t hash = 0;  // of the text, and of what the casts make of it
};

struct Event {
    std::string name;
    uint8_t priority = 1;
};

// Events that the stage itself sends.
enum BuiltIn : uint32_t { event_arrived, event_blocked, event_seen, event_unseen, built_in_events };

// What all machines of a stage share.
struct Vocabulary {
    std::vector<Event> events{{"arrived", 1}, {"blocked", 1}, {"seen", 1}, {"unseen", 3}};
    std::vector<Variable> crowd;
    std::vector<std::string> classes{""};
    std::vector<std::string> actions;  // of the host
    uint32_t find_event(std::string_view event) const;
    uint32_t find_class(std::string_view agent_class) const;
    uint32_t add_class(std::string_view agent_class);
};

// The template's parts of a machine: casts[i].tmpl and locomotion are given, the rest is found.
struct CastDef {
    const clq_template *tmpl = nullptr;
    const clq_locomotion *locomotion = nullptr;
};

// Reads a machine. Throws Error: FORMAT with name, line, column and rule, or LIMIT. `shared` may have got new names
// then.
std::unique_ptr<Machine> read_machine(std::string_view text, const std::string &name, const std::vector<CastDef> &casts,
                                      Vocabulary &shared);

}  // namespace claque::stage
