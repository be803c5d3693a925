// Blinking: one blink per random slot, at a random time of the slot (S0 7.1).
#include "lib/behave/mechanisms.h"

namespace claque::behave
{

namespace
{

// How far the lids are closed after a share of a blink. They fall faster than they rise.
double closing(double share)
{
    if (!(share > 0 && share < 1)) return 0;
    return share < 0.45 ? ease(share, 0.35) : 1 - ease(share - 0.45, 0.55);
}

}  // namespace

void run(const crowd::Blink &blink, const Call &call, Writer &writer) noexcept
{
    const RandomSlots random_slots = call.random_slots(base::Purpose::blink);
    const double t = call.clock_s(), period = static_cast<double>(blink.period_s),
                 length = static_cast<double>(blink.close_s);
    const Slot slot = slot_at(t, period);
    const double begin = slot.begin_s + random_slots.unit(slot.index) * (period - length);
    double shut = closing((t - begin) / length);
    if (call.level > 0) shut = shut > 0.5 ? 1 : 0;
    for (const crowd::DofValue &value : blink.closed) writer.write(value.dof, value.value, static_cast<float>(shut));
}

}  // namespace claque::behave
