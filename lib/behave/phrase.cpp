// Mouth shapes in time: over and over with pauses, and when the host says so (S0 7.1).
#include <algorithm>

#include "lib/behave/face.h"
#include "lib/behave/mechanisms.h"

namespace claque::behave
{

namespace
{

// x seconds after the phrase began; after its end the mouth goes back to rest.
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
        Face face = Face::of(phrase.keys[i].shape);
        face.blend(Face(), change(call, x - length, blend));
        return face;
    }
    const double begin = static_cast<double>(phrase.keys[i].time_s);
    const double end = i + 1 < phrase.keys.size() ? static_cast<double>(phrase.keys[i + 1].time_s) : length;
    Face face = Face::of(i > 0 ? phrase.keys[i - 1].shape : model::none);
    face.blend(Face::of(phrase.keys[i].shape), change(call, x - begin, std::min(blend, end - begin)));
    return face;
}

Face mouth_by_lot(const crowd::Phrase &phrase, const Call &call)
{
    if (phrase.pause_s < 0) return Face();
    const Lot lot = call.lot(base::Purpose::phrase);
    const double said = static_cast<double>(phrase.length_s) + static_cast<double>(phrase.blend_s);
    const double pause = static_cast<double>(phrase.pause_s), t = call.clock_s();
    // The pause is before the phrase, some of it, and after it: between two of them lie 0.5 to 1.5 pauses.
    const Slot slot = slot_at(t, said + pause);
    return mouth_at(phrase, call, t - slot.begin_s - 0.5 * lot.unit(slot.index) * pause);
}

}  // namespace

void run(const crowd::Phrase &phrase, const Call &call, Writer &writer) noexcept
{
    const crowd::Command told = call.command();
    const double length = static_cast<double>(phrase.length_s), blend = static_cast<double>(phrase.blend_s);
    Face face = mouth_by_lot(phrase, call);
    const auto say = [&](const crowd::Order &order) {
        const double x = call.moment.time_s - order.at_s;
        if (order.choice == model::none || !(x >= 0) || x >= length + blend) return;
        face.blend(mouth_at(phrase, call, x), change(call, x, blend) * (1 - change(call, x - length, blend)));
    };
    say(told.before);
    say(told);
    lay(face, base::Span<const crowd::Shape>(phrase.shapes), base::Span<const crowd::DofValue>(phrase.values), writer);
}

}  // namespace claque::behave
