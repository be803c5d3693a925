// Phrases: mouth poses in time, repeated with pauses or on the host's command (S0 7.1).
#include <algorithm>

#include "lib/behave/face.h"
#include "lib/behave/mechanisms.h"

namespace claque::behave
{

namespace
{

// x seconds after the start of the phrase; after its end the mouth returns to rest.
Face mouth_at(const crowd::Phrase &phrase, const Call &call, double x)
{
    const double length = static_cast<double>(phrase.length_s), blend = static_cast<double>(phrase.blend_s);
    if (!(x >= 0) || x >= length + blend) return Face();
    const auto after = std::upper_bound(phrase.keys.begin(), phrase.keys.end(), std::min(x, length),
                                        [](double t, const crowd::PhraseKey &key) { return t < double(key.time_s); });
    size_t i = static_cast<size_t>(after - phrase.keys.begin()) - 1;
    // A key at the very end has no time to be shown.
    if (i > 0 && static_cast<double>(phrase.keys[i].time_s) >= length) --i;
    if (x >= length) {
        Face face = Face::of(phrase.keys[i].pose);
        face.blend(Face(), change(call, x - length, blend));
        return face;
    }
    const double begin = static_cast<double>(phrase.keys[i].time_s);
    const double end = i + 1 < phrase.keys.size() ? static_cast<double>(phrase.keys[i + 1].time_s) : length;
    Face face = Face::of(i > 0 ? phrase.keys[i - 1].pose : model::none);
    face.blend(Face::of(phrase.keys[i].pose), change(call, x - begin, std::min(blend, end - begin)));
    return face;
}

Face random_mouth(const crowd::Phrase &phrase, const Call &call)
{
    if (phrase.pause_s < 0) return Face();
    const RandomSlots random_slots = call.random_slots(base::Purpose::phrase);
    const double said = static_cast<double>(phrase.length_s) + static_cast<double>(phrase.blend_s);
    const double pause = static_cast<double>(phrase.pause_s), t = call.clock_s();
    // Part of the pause comes before the phrase and part after it, so that 0.5 to 1.5 pauses lie between two phrases.
    const Slot slot = slot_at(t, said + pause);
    return mouth_at(phrase, call, t - slot.begin_s - 0.5 * random_slots.unit(slot.index) * pause);
}

}  // namespace

void run(const crowd::Phrase &phrase, const Call &call, Writer &writer) noexcept
{
    const crowd::CommandHistory history = call.command_history();
    const double length = static_cast<double>(phrase.length_s), blend = static_cast<double>(phrase.blend_s);
    Face face = random_mouth(phrase, call);
    const auto blend_phrase = [&](const crowd::Command &command) {
        const double x = call.context.time_s - command.at_s;
        if (command.choice == model::none || !(x >= 0) || x >= length + blend) return;
        face.blend(mouth_at(phrase, call, x), change(call, x, blend) * (1 - change(call, x - length, blend)));
    };
    blend_phrase(history.before);
    blend_phrase(history);
    apply_face(face, base::Span<const crowd::DofPose>(phrase.poses), base::Span<const crowd::DofValue>(phrase.values),
               writer);
}

}  // namespace claque::behave
