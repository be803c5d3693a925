// How the stage moves its agents. The stage says where an agent is to go; a Movement finds the way and publishes pieces
// of tracks. It works in the decisions' flow only, called by one thread at a time, and never sees a crowd: the stage
// hands the pieces to the flow that draws.
//
// Times are those of the stage. Everything up to the time decided is final: a Movement never changes a piece that it
// has published, and what it publishes is a function of the calls that it got, never of threads or of the time of day.
#pragma once

#include <claque/track.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace claque::stage
{

// The number of an agent in its stage, from 0 on; never used again.
using AgentIndex = uint32_t;

// An agent as it walks.
struct Walker {
    const clq_locomotion *locomotion = nullptr;  // never NULL; lives longer than the Movement
    uint64_t seed = 0;
    double position[3] = {};  // world units
    double heading_rad = 0;   // as in claque/track.h
    float scale = 1;          // of the actor's transform
    float radius_m = 0.2f;    // of its body
};

// A place to walk to.
struct Goal {
    double position[3] = {};
    float near_m = 0.3f;     // close enough: the agent has arrived
    float speed_m_s = 1.3f;  // wanted
    // NaN: the agent stands as it came. Otherwise it turns to this heading where it arrives.
    double heading_rad = 0;
    // Having arrived, it moves exactly to the position and stays there beside the ground, in no other's way, until it
    // is sent elsewhere. Wants a heading.
    bool settles = false;
    uint64_t request = 0;  // named by the Arrival that answers
};

// The answer to a Goal, once for each that was not replaced by a later one or by stop().
struct Arrival {
    AgentIndex agent = 0;
    uint64_t request = 0;
    double time_s = 0;     // after the time decided before this advance, up to the new one
    bool reached = false;  // false: there is no way, or the agent has given up
};

// A finished piece of an agent's way. The actor follows it with clq_actor_follow_track(crowd, actor, track, start_s)
// from from_s on, until the next piece of the same agent begins.
struct Piece {
    AgentIndex agent = 0;
    double from_s = 0;           // when the actor begins to follow: in the same range as Arrival::time_s
    double start_s = 0;          // the zero of the track's own clock, on the stage's clock
    clq_track *track = nullptr;  // the receiver gets the Movement's hold and ends it with clq_track_destroy.
                                 // NULL: the actor leaves its track at from_s and stands (clq_actor_leave_track)
    bool rises = false;          // the first one of an agent that had settled
};

struct Moved {
    std::vector<Piece> pieces;      // of one agent in ascending from_s
    std::vector<Arrival> arrivals;  // in any order
};

struct Place {
    double position[3] = {};
    double heading_rad = 0;
    float speed_m_s = 0;
};

class Movement
{
public:
    virtual ~Movement() = default;

    // Throws stage::Error (ARGUMENT), naming the rule, if there is no place for the walker near its position.
    virtual void add(AgentIndex agent, const Walker &walker, double at_s) = 0;
    virtual void remove(AgentIndex agent, double at_s) = 0;

    // Replaces the goal that the agent had. `at_s` lies after the time decided: within the range of the next advance. A
    // Movement that simulates ahead turns the agent from its own horizon on.
    virtual void go(AgentIndex agent, const Goal &goal, double at_s) = 0;
    virtual void stop(AgentIndex agent, double at_s) = 0;

    // Decides everything up to until_s, the end of the stage's next tick: appends the pieces that begin, and the
    // answers that come, after the last advance and up to until_s. If it throws, the Movement is as it was.
    virtual void advance(double until_s, Moved &out) = 0;

    // Where an agent is, at a time up to the last advance's until_s and at most a second before it.
    virtual Place place(AgentIndex agent, double time_s) const = 0;

    // Declared cost of one go(), in the units of clq_stage_def.budget.
    virtual uint32_t cost_of_go() const = 0;

    // Appends the whole state, without tracks: the stage saves those that actors follow. restore() gets what save()
    // wrote, for the same walkers; it throws stage::Error (FORMAT) on anything else and leaves all as it was.
    virtual void save(std::vector<uint8_t> &out) const = 0;
    virtual void restore(const uint8_t *bytes, size_t size_bytes) = 0;
};

}  // namespace claque::stage

// Gives a stage its movement; only before its first agent that walks. Used by calls of the C API that make one.
void clq_stage_set_movement(struct clq_stage *stage, std::unique_ptr<claque::stage::Movement> movement);
