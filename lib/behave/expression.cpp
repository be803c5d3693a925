// Faces by lot, or as the host commands (S0 7.1).
#include "lib/behave/face.h"
#include "lib/behave/mechanisms.h"

namespace claque::behave
{

namespace
{

// Neighbouring slots have different shapes, and each is known without the ones before: even slots draw freely, odd ones
// among those that neither neighbour has.
uint32_t shape_of_slot(int64_t slot, uint32_t count, const Lot &lot)
{
    const auto draw = [&](int64_t k, uint32_t n) { return static_cast<uint32_t>(lot.bits(k) % n); };
    if (count == 1) return 0;
    if (count == 2) return static_cast<uint32_t>((static_cast<uint64_t>(slot) + lot.bits(0)) & 1);
    if ((slot & 1) == 0) return draw(slot, count);
    uint32_t low = draw(slot - 1, count), high = draw(slot + 1, count);
    if (low > high) std::swap(low, high);
    uint32_t shape = draw(slot, count - (low == high ? 1 : 2));
    if (shape >= low) ++shape;
    if (low != high && shape >= high) ++shape;
    return shape;
}

Face face_by_lot(const crowd::Expression &expression, const Call &call)
{
    const Lot lot = call.lot(base::Purpose::expression);
    const double t = call.clock_s();
    const Slot slot = uneven_slot_at(t, static_cast<double>(expression.hold_s), lot);
    const uint32_t count = static_cast<uint32_t>(expression.shapes.size());
    Face face = Face::of(shape_of_slot(slot.index - 1, count, lot));
    face.blend(Face::of(shape_of_slot(slot.index, count, lot)),
               change(call, t - slot.begin_s, static_cast<double>(expression.blend_s)));
    return face;
}

}  // namespace

void run(const crowd::Expression &expression, const Call &call, Writer &writer) noexcept
{
    const crowd::Command told = call.command();
    const double time = call.moment.time_s, blend = static_cast<double>(expression.blend_s);
    const auto chosen = [&](uint32_t choice) {
        return choice == model::none ? face_by_lot(expression, call) : Face::of(choice);
    };
    // What came before is looked at only while it still shows.
    const double by = time >= told.at_s ? change(call, time - told.at_s, blend) : 0;
    Face face;
    if (by < 1) {
        const double by_before = time >= told.before.at_s ? change(call, time - told.before.at_s, blend) : 0;
        if (by_before < 1) face = chosen(told.before.choice_before);
        if (by_before > 0) face.blend(chosen(told.before.choice), by_before);
    }
    if (by > 0) face.blend(chosen(told.choice), by);
    lay(face, base::Span<const crowd::Shape>(expression.shapes), base::Span<const crowd::DofValue>(expression.values),
        writer);
}

}  // namespace claque::behave
