// Clips by lot (S0 7.1). Slots are equally long, so that a clip that fits in one a whole number of times is never cut;
// where an actor's slots begin is drawn by lot, so that a crowd does not change all at once.
#include "lib/behave/mechanisms.h"

namespace claque::behave
{

crowd::Play drawn(const crowd::Idle &idle, const crowd::Crowd &crowd, uint32_t row, const crowd::Use &use,
                  double time_s) noexcept
{
    const Lot lot = lot_of(crowd, row, use.mechanism, base::Purpose::idle);
    const double length = static_cast<double>(idle.slot_s), shift = lot.unit(0, 1) * length;
    const Slot slot = slot_at(clock_of(use, time_s) + shift, length);
    crowd::Play play;
    play.clip = idle.clips[static_cast<size_t>(lot.bits(slot.index) % idle.clips.size())];
    play.start_s = slot.begin_s - shift - static_cast<double>(use.phase_s) + use.start_s;
    return play;
}

}  // namespace claque::behave
