// The behaviour of one actor at one time (S0 5.3, 7.1): the values that its control mechanisms write, the clip it
// plays, and the transform of its Skeleton Root. These are functions of time, seed and commands; they keep no state,
// allocate nothing and never throw. They also call the host's mechanisms, so actors that have such are evaluated by one
// thread.
#pragma once

#include "lib/base/host_call.h"
#include "lib/crowd/crowd.h"

namespace claque::behave
{

// Calls of mechanisms since the counters were set to 0, by kind as in crowd::MechanismKind.
struct Counts {
    uint64_t calls[6] = {0, 0, 0, 0, 0, 0};
    uint64_t writes = 0;  // of degrees of freedom
    void add(const Counts &other)
    {
        for (int k = 0; k < 6; ++k) calls[k] += other.calls[k];
        writes += other.writes;
    }
};

// The level of each of an actor's mechanisms at a distance, four bits per attachment in chain order; 15: off.
//   distance_m   effective: includes priority and the scales of view and actor
//   level        of the template: the skeleton that remains
using MechanismLevels = uint64_t;
constexpr uint32_t off = 15;
MechanismLevels mechanism_levels(const crowd::Crowd &crowd, uint32_t row, float distance_m,
                                 const model::Level &level) noexcept;

inline uint32_t mechanism_level(MechanismLevels levels, uint32_t attachment)
{
    return static_cast<uint32_t>(levels >> (4 * attachment)) & 15;
}

// Whether one of the actor's mechanisms is the host's and keeps memory.
bool has_memory(const crowd::Crowd &crowd, uint32_t row) noexcept;

struct EvaluationContext {
    double time_s = 0;  // the tick that is shown
    MechanismLevels levels = 0;
    const model::Level *level = nullptr;  // of the template
    float distance_m = 0;                 // to the eye; passed to the host
    bool visible = true;                  // passed to the host
    bool wanted = true;  // false: the degrees of freedom are not needed, only mechanisms with memory run
    base::HostCalls *host_calls = nullptr;  // of the update: keeps the first exception of host mechanisms
};

// Runs an actor's mechanisms in ascending order of priority. Sets `dofs` [rig.dofs.size()] to rest first; every value
// stays within its range.
void run(const crowd::Crowd &crowd, uint32_t row, const EvaluationContext &context, base::Span<float> dofs,
         Counts &counts) noexcept;

// What the actor plays: its own clip, or the random choice of the last of its idle mechanisms that is not off.
struct Plays {
    crowd::Play now, before;  // `before` fades out as the weight of `now` grows to 1
    double weight = 1;
    bool idle = false;  // chosen at random
};
Plays plays_at(const crowd::Crowd &crowd, uint32_t row, double time_s, MechanismLevels levels) noexcept;

// The transform of its Skeleton Root in the Reference Point's space, with scale 1 and without the ground.
crowd::Transform root_transform_at(const crowd::Crowd &crowd, uint32_t row, double time_s) noexcept;

// The transform on a path alone. `round_s` in [0, duration_s).
crowd::Transform transform_on(const crowd::RootPath &path, double round_s) noexcept;

// How fast its root path moves and turns its Skeleton Root, in the Reference Point's space. A flight turns about its
// upward axis; its pitch and bank are left out.
struct RootSpeed {
    double speed = 0, turn_rad_s = 0;
};
RootSpeed root_speed_at(const crowd::Crowd &crowd, uint32_t row, double time_s) noexcept;
// A tight upper bound of the distance of the path's points from the origin.
float reach_of(const crowd::RootPath &path);

}  // namespace claque::behave
