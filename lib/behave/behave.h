// Behaviour of one actor at one moment (S0 5.3, 7.1): what its control mechanisms write into its degrees of freedom, which
// clip it plays, where its Skeleton Root is. Functions of time, seed and commands; nothing here keeps anything, allocates
// or throws. A host's own mechanisms are called from here, so actors that have some are for one thread.
#pragma once

#include "lib/crowd/crowd.h"

namespace claque::behave
{

// Calls of mechanisms, by kind as in crowd::MechanismKind, since they were set to 0.
struct Counts {
    uint64_t calls[6] = {0, 0, 0, 0, 0, 0};
    uint64_t writes = 0;  // of degrees of freedom
    void add(const Counts &other)
    {
        for (int k = 0; k < 6; ++k) calls[k] += other.calls[k];
        writes += other.writes;
    }
};

// The level of each of an actor's mechanisms at a distance, four bits a use in the order of its chain; 15: off.
//   distance_m   effective: priority and the view's screen size are in it already
//   level        of the template: what is left of the skeleton
using MechanismLevels = uint64_t;
constexpr uint32_t off = 15;
MechanismLevels mechanism_levels(const crowd::Crowd &crowd, uint32_t row, float distance_m,
                                 const model::Level &level) noexcept;

inline uint32_t mechanism_level(MechanismLevels levels, uint32_t attachment)
{
    return static_cast<uint32_t>(levels >> (4 * attachment)) & 15;
}

// Whether one of its mechanisms is the host's, and whether one of these keeps a memory.
bool has_host(const crowd::Crowd &crowd, uint32_t row) noexcept;
bool has_memory(const crowd::Crowd &crowd, uint32_t row) noexcept;

struct EvaluationContext {
    double time_s = 0;  // the tick that is shown
    MechanismLevels levels = 0;
    const model::Level *level = nullptr;  // of the template
    float distance = 0;                   // to the eye, world units: told to the host
    bool visible = true;                  // told to the host
    bool wanted = true;                   // false: nobody asks for the degrees of freedom; only memories are kept up
};

// Runs an actor's mechanisms, the lowest priority first. `dofs`: [rig.dofs.size()], set to rest first; every value stays
// within its range.
void run(const crowd::Crowd &crowd, uint32_t row, const EvaluationContext &context, base::Span<float> dofs,
         Counts &counts) noexcept;

// What it plays: its own, or what the last of its idle mechanisms that is not off has drawn.
struct Plays {
    crowd::Play now, before;  // `before` goes while the weight of `now` grows to 1
    double weight = 1;
    bool idle = false;  // drawn
};
Plays plays_at(const crowd::Crowd &crowd, uint32_t row, double time_s, MechanismLevels levels) noexcept;
crowd::Play play_at(const crowd::Crowd &crowd, uint32_t row, double time_s, MechanismLevels levels) noexcept;

// Where its Skeleton Root is in the Reference Point's space, and how it is turned; scale 1. Without the ground.
crowd::Transform root_transform_at(const crowd::Crowd &crowd, uint32_t row, double time_s) noexcept;

// A path alone. `round` in [0, duration_s).
crowd::Transform transform_on(const crowd::RootPath &path, double round_s) noexcept;
// No point of it is farther from the origin: an upper bound that is tight.
float reach_of(const crowd::RootPath &path);

}  // namespace claque::behave
