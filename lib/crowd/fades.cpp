// What hosts command an actor to play: each call writes down what that replaces, so that moments before it still show what
// was true then.
#include <algorithm>
#include <cmath>

#include "lib/base/error.h"
#include "lib/crowd/crowd.h"
#include "lib/crowd/gait.h"

namespace claque::crowd
{

using base::fail;
using model::none;

namespace
{

void check_length(const char *what, float length_s)
{
    if (!(length_s >= 0) || !std::isfinite(length_s))
        fail(CLQ_ARGUMENT, "%s of %g s: 0 or more is wanted", what, static_cast<double>(length_s));
}

void check_moment(double at_s)
{
    if (!std::isfinite(at_s)) fail(CLQ_ARGUMENT, "a command begins at %g s: a finite time is wanted", at_s);
}

// Fades and gestures that are over at a moment.
void forget_before(Layering &layering, double at_s)
{
    // What lies under an inertial fade goes on as a difference until it is over by itself; a cross-fade that is over hides
    // all before it.
    uint32_t over = 0;
    bool all = true;
    for (uint32_t k = 0; k < layering.fade_count; ++k) {
        const Fade &fade = layering.fades[k];
        const bool ends = fade.at_s + static_cast<double>(fade.length_s) <= at_s;
        all = all && ends;
        if (ends && (all || fade.curve != Curve::inertial)) over = k + 1;
    }
    for (uint32_t k = over; k < layering.fade_count; ++k) layering.fades[k - over] = layering.fades[k];
    for (uint32_t k = layering.fade_count - over; k < layering.fade_count; ++k) layering.fades[k] = Fade();
    layering.fade_count -= over;
    uint32_t kept = 0;
    for (uint32_t k = 0; k < layering.gesture_count; ++k)
        if (layering.gestures[k].end_s > at_s) layering.gestures[kept++] = layering.gestures[k];
    for (uint32_t k = kept; k < layering.gesture_count; ++k) layering.gestures[k] = Gesture();
    layering.gesture_count = kept;
}

// As `add` leaves it, which says false where there is no room. What is over is kept until its room is wanted: somebody may
// ask for moments before.
template <class Add>
Layering with_room(const Layering &before, double at_s, const Add &add)
{
    Layering wanted = before;
    if (add(wanted) && wanted.most_layers() <= most_shown) return wanted;
    wanted = before;
    forget_before(wanted, at_s);
    if (add(wanted) && wanted.most_layers() <= most_shown) return wanted;
    fail(CLQ_LIMIT,
         "no room for what begins at %g s: of one actor at most %u fades, %u layers and %u clips run together", at_s,
         most_fades, most_gestures, most_shown);
}

void forget_from(Layering &layering, double at_s)
{
    while (layering.fade_count > 0 && layering.fades[layering.fade_count - 1].at_s >= at_s) {
        Fade &last = layering.fades[--layering.fade_count];
        layering.now = last.from;
        last = Fade();
    }
}

void check_inertial(const Layering &layering, const Source &to)
{
    bool inertial = false, gait = to.gait != none;
    for (uint32_t k = 0; k < layering.fade_count; ++k) {
        inertial = inertial || layering.fades[k].curve == Curve::inertial;
        gait = gait || layering.fades[k].from.gait != none;
    }
    if (inertial && gait)
        fail(CLQ_UNSUPPORTED, "an inertial fade goes from one clip to another: gaits fade by the other curves");
}

}  // namespace

void Crowd::change(uint32_t row, const Layering &wanted)
{
    Layering &there = layers_.make(row);
    const uint32_t link = there.next_free;
    there = wanted;
    there.next_free = link;
    plays_[row] = wanted.now.play;
    layers_.settle(row);
    new_version(row);
    measure(row);
}

void Crowd::watch(Id id, bool watched)
{
    const uint32_t row = row_of(id);
    const auto at = std::lower_bound(watched_.begin(), watched_.end(), row);
    const bool there = at != watched_.end() && *at == row;
    if (there && !watched) watched_.erase(at);
    if (!there && watched) watched_.insert(at, row);
}

Layering Crowd::layering_of(uint32_t row) const
{
    Layering out;
    if (const Layering *there = layers_.of(row)) out = *there;
    out.now.play = plays_[row];
    return out;
}

Source Crowd::source(uint32_t row, const Play &play, uint32_t gait, float share) const
{
    Source out;
    out.play = play;
    const model::Template &tmpl = template_of(row);
    if (gait != none) {
        if (gait >= layers_.gait_count()) fail(CLQ_ARGUMENT, "gait %u of %u", gait + 1, layers_.gait_count());
        const Gait &of = layers_.gait(gait);
        if (of.tmpl != &tmpl)
            fail(CLQ_ARGUMENT, "gait %u is of template '%s', the actor of '%s'", gait + 1, of.tmpl->name.c_str(),
                 tmpl.name.c_str());
        if (!(share >= 0 && share <= 1))
            fail(CLQ_ARGUMENT, "a share of %g of the second gait: 0 to 1 is wanted", static_cast<double>(share));
        out.gait = gait;
        out.share_from = out.share = share;
        out.play.clip = of.clip_a;
        out.change_s = play.start_s;
        const model::Clip &clip = tmpl.rig.clips[of.clip_a];
        out.change_rounds = share_of_a(of, static_cast<double>(clip.start_s) + static_cast<double>(play.phase_s));
    }
    check_play(out.play, tmpl);
    return out;
}

void Crowd::check_source(uint32_t row, const Source &source) const
{
    const Source made = this->source(row, source.play, source.gait, source.share);
    const bool gait = made.gait == none || made.play.clip == source.play.clip;
    if (!gait || !(source.share_from >= 0 && source.share_from <= 1) || !std::isfinite(source.change_s) ||
        !std::isfinite(source.change_rounds))
        fail(CLQ_ARGUMENT, "a gait that no command leads to");
    check_length("a change of gait", source.change_length_s);
}

void Crowd::restore_layering(uint32_t row, const Layering &read)
{
    check_source(row, read.now);
    for (uint32_t k = 0; k < read.fade_count; ++k) {
        const Fade &fade = read.fades[k];
        check_source(row, fade.from);
        check_moment(fade.at_s);
        check_length("a fade", fade.length_s);
        if (fade.curve > Curve::inertial || (k > 0 && !(read.fades[k - 1].at_s < fade.at_s)))
            fail(CLQ_ARGUMENT, "a fade that no command leads to");
    }
    for (uint32_t k = 0; k < read.gesture_count; ++k) check_gesture(row, read.gestures[k]);
    check_inertial(read, read.now);
    with_room(read, -never_s, [](Layering &) { return true; });
    change(row, read);
}

void Crowd::play(Id id, const Source &source)
{
    const uint32_t row = row_of(id);
    Layering wanted = layering_of(row);
    wanted.fade_count = 0;
    for (Fade &fade : wanted.fades) fade = Fade();
    wanted.now = source;
    wanted = with_room(wanted, -never_s, [](Layering &) { return true; });
    change(row, wanted);
}

void Crowd::fade_to(Id id, const Source &source, double at_s, float length_s, Curve curve)
{
    const uint32_t row = row_of(id);
    check_moment(at_s);
    check_length("a fade", length_s);
    Layering before = layering_of(row);
    forget_from(before, at_s);
    const Layering wanted = with_room(before, at_s, [&](Layering &to) {
        if (to.fade_count == most_fades) return false;
        Fade &fade = to.fades[to.fade_count++];
        fade.from = to.now;
        fade.at_s = at_s, fade.length_s = length_s, fade.curve = curve;
        to.now = source;
        return true;
    });
    check_inertial(wanted, source);
    change(row, wanted);
}

void Crowd::change_share(Id id, float share, double at_s, float length_s)
{
    const uint32_t row = row_of(id);
    check_moment(at_s);
    check_length("a change of gait", length_s);
    if (!(share >= 0 && share <= 1))
        fail(CLQ_ARGUMENT, "a share of %g of the second gait: 0 to 1 is wanted", static_cast<double>(share));
    Layering wanted = layering_of(row);
    Source &now = wanted.now;
    if (now.gait == none) fail(CLQ_ARGUMENT, "the actor plays no gait");
    const double rounds = rounds_at(layers_.gait(now.gait), now, at_s);
    if (!std::isfinite(rounds)) fail(CLQ_ARGUMENT, "at %g s the gait has no phase", at_s);
    now.share_from = share_at(now, at_s);
    now.change_rounds = rounds;
    now.change_s = at_s;
    now.share = share;
    now.change_length_s = length_s;
    change(row, wanted);
}

void Crowd::check_gesture(uint32_t row, const Gesture &gesture) const
{
    const model::Template &tmpl = template_of(row);
    check_play(gesture.play, tmpl);
    Play reference;
    reference.clip = gesture.reference_clip;
    check_play(reference, tmpl);
    check_moment(gesture.start_s);
    if (!std::isfinite(gesture.reference_time_s)) fail(CLQ_ARGUMENT, "the reference's time is not finite");
    check_length("a layer's fade in", gesture.fade_in_s);
    check_length("a layer's fade out", gesture.fade_out_s);
    if (!(gesture.end_s >= gesture.start_s))
        fail(CLQ_ARGUMENT, "a layer from %g s ends at %g s", gesture.start_s, gesture.end_s);
    if (gesture.curve > Curve::inertial) fail(CLQ_ARGUMENT, "a layer of no curve");
    const float most = gesture.adds ? most_weight : 1;
    if (!(gesture.weight <= most && gesture.weight >= (gesture.adds ? -most_weight : 0)))
        fail(CLQ_ARGUMENT, "a layer's weight is %g: %g to %g is wanted", static_cast<double>(gesture.weight),
             gesture.adds ? -static_cast<double>(most_weight) : 0.0, static_cast<double>(most));
    if (gesture.curve == Curve::inertial) fail(CLQ_ARGUMENT, "a layer does not come in by inertia");
    if (gesture.mask == none) return;
    if (gesture.mask >= layers_.mask_count())
        fail(CLQ_ARGUMENT, "mask %u of %u", gesture.mask + 1, layers_.mask_count());
    if (layers_.mask(gesture.mask).tmpl != &tmpl)
        fail(CLQ_ARGUMENT, "mask %u is of template '%s', the actor of '%s'", gesture.mask + 1,
             layers_.mask(gesture.mask).tmpl->name.c_str(), tmpl.name.c_str());
}

uint32_t Crowd::add_gesture(Id id, const Gesture &gesture)
{
    const uint32_t row = row_of(id);
    check_gesture(row, gesture);
    Layering wanted = with_room(layering_of(row), gesture.start_s, [&](Layering &to) {
        if (to.gesture_count == most_gestures) return false;
        to.gestures[to.gesture_count++] = gesture;
        return true;
    });
    layers_.make(row);  // so that nothing fails once the name is given
    const uint32_t serial = layers_.next_serial();
    wanted.gestures[wanted.gesture_count - 1].serial = serial;
    change(row, wanted);
    return serial;
}

void Crowd::end_gesture(Id id, uint32_t serial, double at_s, float fade_out_s)
{
    const uint32_t row = row_of(id);
    check_moment(at_s);
    check_length("a layer's fade out", fade_out_s);
    Layering wanted = layering_of(row);
    for (uint32_t k = 0; k < wanted.gesture_count; ++k) {
        Gesture &gesture = wanted.gestures[k];
        if (gesture.serial != serial) continue;
        const double end_s = at_s + static_cast<double>(fade_out_s);
        if (end_s < gesture.end_s) {
            gesture.end_s = end_s < gesture.start_s ? gesture.start_s : end_s;
            gesture.fade_out_s = fade_out_s;
        }
        change(row, wanted);
        return;
    }
    fail(CLQ_STALE_ID, "the actor has no layer %u: it is over, and another has begun since", serial);
}

}  // namespace claque::crowd
