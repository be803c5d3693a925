// The kinds of control mechanisms: what each writes at a moment. A file for each.
#pragma once

#include "lib/behave/lot.h"
#include "lib/behave/writer.h"

namespace claque::behave
{

// One use of one mechanism by one actor.
struct Call {
    const crowd::Crowd &crowd;
    uint32_t row;
    const crowd::Use &use;
    uint32_t level;
    const Moment &moment;

    const crowd::Mechanism &mechanism() const { return crowd.behaviours().mechanism(use.mechanism); }
    double clock_s() const { return clock_of(use, moment.time_s); }
    Lot lot(base::Purpose purpose) const { return lot_of(crowd, row, use.mechanism, purpose); }
    crowd::Command command() const
    {
        const crowd::Command *told = crowd.behaviours().command_of(use);
        return told ? *told : crowd::Command();
    }
};

// The share of a change that has happened: smooth at level 0, at once from level 1 on.
double change(const Call &call, double t_s, double length_s) noexcept;

void run(const crowd::Gaze &gaze, const Call &call, Writer &writer) noexcept;
void run(const crowd::Expression &expression, const Call &call, Writer &writer) noexcept;
void run(const crowd::Blink &blink, const Call &call, Writer &writer) noexcept;
void run(const crowd::Phrase &phrase, const Call &call, Writer &writer) noexcept;
void run(const crowd::HostMechanism &host, const Call &call, Writer &writer) noexcept;

Plays drawn(const crowd::Idle &idle, const crowd::Crowd &crowd, uint32_t row, const crowd::Use &use,
            double time_s) noexcept;

// Where an actor looks: yaw to its left, pitch upwards, before anything is held to a range.
struct Look {
    double yaw = 0, pitch = 0;
};
// At a moment, as it was told to.
Look look_at(const crowd::Gaze &gaze, const Lot &lot, double clock_s, const crowd::Command &told,
             const crowd::Crowd &crowd, uint32_t row, double time_s) noexcept;
// Where one order alone ends.
Look target_of(const crowd::Gaze &gaze, const Lot &lot, double clock_s, const crowd::Order &order,
               const crowd::Crowd &crowd, uint32_t row, double time_s) noexcept;

}  // namespace claque::behave
