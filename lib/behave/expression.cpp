// Expressions: random, or commanded by the host (S0 7.1).
#include "lib/behave/face.h"
#include "lib/behave/mechanisms.h"

namespace claque::behave
{

namespace
{

// Neighbouring slots have different poses, and each slot is found without the ones before. Even slots choose freely,
// odd ones from the poses that neither neighbour has.
uint32_t pose_of_slot(int64_t slot, uint32_t count, const RandomSlots &random_slots)
{
    const auto sample = [&](int64_t k, uint32_t n) { return static_cast<uint32_t>(random_slots.bits(k) % n); };
    if (count == 1) return 0;
    if (count == 2) return static_cast<uint32_t>((static_cast<uint64_t>(slot) + random_slots.bits(0)) & 1);
    if ((slot & 1) == 0) return sample(slot, count);
    uint32_t low = sample(slot - 1, count), high = sample(slot + 1, count);
    if (low > high) std::swap(low, high);
    uint32_t pose = sample(slot, count - (low == high ? 1 : 2));
    if (pose >= low) ++pose;
    if (low != high && pose >= high) ++pose;
    return pose;
}

Face random_face(const crowd::Expression &expression, const Call &call)
{
    const RandomSlots random_slots = call.random_slots(base::Purpose::expression);
    const double t = call.clock_s();
    const Slot slot = uneven_slot_at(t, static_cast<double>(expression.hold_s), random_slots);
    const uint32_t count = static_cast<uint32_t>(expression.poses.size());
    Face face = Face::of(pose_of_slot(slot.index - 1, count, random_slots));
    face.blend(Face::of(pose_of_slot(slot.index, count, random_slots)),
               change(call, t - slot.begin_s, static_cast<double>(expression.blend_s)));
    return face;
}

}  // namespace

void run(const crowd::Expression &expression, const Call &call, Writer &writer) noexcept
{
    const crowd::CommandHistory history = call.command_history();
    const double time = call.context.time_s, blend = static_cast<double>(expression.blend_s);
    const auto chosen = [&](uint32_t choice) {
        return choice == model::none ? random_face(expression, call) : Face::of(choice);
    };
    // The previous command is evaluated only while it is still visible.
    const double by = time >= history.at_s ? change(call, time - history.at_s, blend) : 0;
    Face face;
    if (by < 1) {
        const double by_before = time >= history.before.at_s ? change(call, time - history.before.at_s, blend) : 0;
        if (by_before < 1) face = chosen(history.before.choice_before);
        if (by_before > 0) face.blend(chosen(history.before.choice), by_before);
    }
    if (by > 0) face.blend(chosen(history.choice), by);
    apply_face(face, base::Span<const crowd::DofPose>(expression.poses),
               base::Span<const crowd::DofValue>(expression.values), writer);
}

}  // namespace claque::behave
