// Random slots: intervals of time to which random choices belong. Any time finds its slot without the slots before it.
#pragma once

#include "lib/base/hash.h"
#include "lib/crowd/crowd.h"

namespace claque::behave
{

// The random numbers of one actor for one of its mechanisms.
struct RandomSlots {
    uint64_t seed = 0;
    base::Purpose purpose = base::Purpose::gaze;

    uint64_t bits(int64_t slot, uint32_t which = 0) const
    {
        return base::hash(seed, which, purpose, static_cast<uint64_t>(slot));
    }
    double unit(int64_t slot, uint32_t which = 0) const  // [0, 1)
    {
        return static_cast<double>(base::unit(bits(slot, which)));
    }
};

RandomSlots random_slots_of(const crowd::Crowd &crowd, uint32_t row, uint32_t mechanism,
                            base::Purpose purpose) noexcept;

struct Slot {
    int64_t index = 0;
    double begin_s = 0;
};

// Slot k is [k, k + 1) lengths.
Slot slot_at(double t_s, double length_s) noexcept;

// As slot_at, but each boundary is moved at random by up to a quarter of the length: slots last 0.5 to 1.5 lengths.
Slot uneven_slot_at(double t_s, double length_s, const RandomSlots &random_slots) noexcept;

// 0 before 0, 1 from `length_s` on, smooth in between; length 0 is a step.
double ease(double t_s, double length_s) noexcept;

// The clock of an attachment.
inline double clock_of(const crowd::MechanismAttachment &attachment, double time_s) noexcept
{
    return time_s - attachment.start_s + static_cast<double>(attachment.phase_s);
}

}  // namespace claque::behave
