// Idle: random clips (S0 7.1). Slots have equal lengths, so that a clip whose length divides them is never cut. The
// start of an actor's slots is random, so that a crowd does not change all at once.
#include "lib/behave/mechanisms.h"

namespace claque::behave
{

namespace
{

// Which sample of a slot; slot 0 has one more, for the start of the slots.
enum Sample : uint32_t { clip_sample = 0, shift_sample = 1, speed_sample = 2, phase_sample = 3 };

uint32_t clip_of(const crowd::Idle &idle, const RandomSlots &random_slots, int64_t slot)
{
    if (idle.weights.empty())
        return idle.clips[static_cast<size_t>(random_slots.bits(slot, clip_sample) % idle.clips.size())];
    double sum = 0;
    for (const float weight : idle.weights) sum += static_cast<double>(weight);
    double left = random_slots.unit(slot, clip_sample) * sum;
    size_t last = 0;
    for (size_t k = 0; k < idle.clips.size(); ++k) {
        if (!(idle.weights[k] > 0)) continue;
        last = k;
        left -= static_cast<double>(idle.weights[k]);
        if (left < 0) break;
    }
    return idle.clips[last];
}

}  // namespace

Plays idle_plays(const crowd::Idle &idle, const crowd::Crowd &crowd, uint32_t row,
                 const crowd::MechanismAttachment &attachment, double time_s) noexcept
{
    const RandomSlots random_slots = random_slots_of(crowd, row, attachment.mechanism, base::Purpose::idle);
    const double length = static_cast<double>(idle.slot_s), shift = random_slots.unit(0, shift_sample) * length;
    const double clock = clock_of(attachment, time_s) + shift;
    const Slot slot = slot_at(clock, length);
    const auto play_in = [&](int64_t index, double begin_s) {
        crowd::Play play;
        play.clip = clip_of(idle, random_slots, index);
        play.start_s = begin_s - shift - static_cast<double>(attachment.phase_s) + attachment.start_s;
        if (idle.speed_spread > 0)
            play.speed =
                static_cast<float>(1 + (2 * random_slots.unit(index, speed_sample) - 1) * double(idle.speed_spread));
        if (idle.phase_spread > 0)
            play.phase_s = static_cast<float>(random_slots.unit(index, phase_sample) * double(idle.phase_spread) *
                                              double(crowd.template_of(row).rig.clips[play.clip].duration_s));
        return play;
    };
    Plays plays;
    plays.idle = true;
    plays.now = play_in(slot.index, slot.begin_s);
    const double fade = static_cast<double>(idle.fade_s);
    if (clock - slot.begin_s < fade) {
        plays.before = play_in(slot.index - 1, slot.begin_s - length);
        plays.weight = ease(clock - slot.begin_s, fade);
    }
    return plays;
}

}  // namespace claque::behave
