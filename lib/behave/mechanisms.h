// The kinds of control mechanisms: what each writes at a time. Each has a file of its own.
#pragma once

#include "lib/behave/random_slots.h"
#include "lib/behave/writer.h"

namespace claque::behave
{

// One evaluation of a mechanism that is attached to an actor.
struct Call {
    const crowd::Crowd &crowd;
    uint32_t row;
    const crowd::MechanismAttachment &attachment;
    uint32_t level;
    const EvaluationContext &context;

    const crowd::Mechanism &mechanism() const { return crowd.behaviours().mechanism(attachment.mechanism); }
    double clock_s() const { return clock_of(attachment, context.time_s); }
    RandomSlots random_slots(base::Purpose purpose) const
    {
        return random_slots_of(crowd, row, attachment.mechanism, purpose);
    }
    crowd::CommandHistory command_history() const
    {
        const crowd::CommandHistory *history = crowd.behaviours().command_history_of(attachment);
        return history ? *history : crowd::CommandHistory();
    }
};

// The share of a change that is complete: smooth at level 0, immediate from level 1 on.
double change(const Call &call, double t_s, double length_s) noexcept;

void run(const crowd::Gaze &gaze, const Call &call, Writer &writer) noexcept;
void run(const crowd::Expression &expression, const Call &call, Writer &writer) noexcept;
void run(const crowd::Blink &blink, const Call &call, Writer &writer) noexcept;
void run(const crowd::Phrase &phrase, const Call &call, Writer &writer) noexcept;
void run(const crowd::HostMechanism &host, const Call &call, Writer &writer) noexcept;

Plays idle_plays(const crowd::Idle &idle, const crowd::Crowd &crowd, uint32_t row,
                 const crowd::MechanismAttachment &attachment, double time_s) noexcept;

// Where an actor looks: yaw to its left, pitch upwards, before limits to ranges.
struct GazeDirection {
    double yaw = 0, pitch = 0;
};
// The direction at a time under its commands.
GazeDirection gaze_direction_at(const crowd::Gaze &gaze, const RandomSlots &random_slots, double clock_s,
                                const crowd::CommandHistory &history, const crowd::Crowd &crowd, uint32_t row,
                                double time_s) noexcept;
// The final direction of one command alone.
GazeDirection target_of(const crowd::Gaze &gaze, const RandomSlots &random_slots, double clock_s,
                        const crowd::Command &command, const crowd::Crowd &crowd, uint32_t row, double time_s) noexcept;

}  // namespace claque::behave
