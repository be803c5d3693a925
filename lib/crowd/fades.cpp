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
void forget_before(LayerState &layer_state, double at_s)
{
    // What lies under an inertial fade goes on as a difference until it is over by itself; a cross-fade that is over hides
    // all before it.
    uint32_t over = 0;
    bool all = true;
    for (uint32_t k = 0; k < layer_state.fade_count; ++k) {
        const Fade &fade = layer_state.fades[k];
        const bool ends = fade.at_s + static_cast<double>(fade.length_s) <= at_s;
        all = all && ends;
        if (ends && (all || fade.curve != Curve::inertial)) over = k + 1;
    }
    for (uint32_t k = over; k < layer_state.fade_count; ++k) layer_state.fades[k - over] = layer_state.fades[k];
    for (uint32_t k = layer_state.fade_count - over; k < layer_state.fade_count; ++k) layer_state.fades[k] = Fade();
    layer_state.fade_count -= over;
    uint32_t kept = 0;
    for (uint32_t k = 0; k < layer_state.layer_count; ++k)
        if (layer_state.layers[k].end_s > at_s) layer_state.layers[kept++] = layer_state.layers[k];
    for (uint32_t k = kept; k < layer_state.layer_count; ++k) layer_state.layers[k] = Layer();
    layer_state.layer_count = kept;
}

// As `add` leaves it, which says false where there is no room. What is over is kept until its room is wanted: somebody may
// ask for moments before.
template <class Add>
LayerState with_room(const LayerState &before, double at_s, const Add &add)
{
    LayerState wanted = before;
    if (add(wanted) && wanted.max_clip_count() <= max_active_clips) return wanted;
    wanted = before;
    forget_before(wanted, at_s);
    if (add(wanted) && wanted.max_clip_count() <= max_active_clips) return wanted;
    fail(CLQ_LIMIT,
         "no room for what begins at %g s: of one actor at most %u fades, %u layers and %u clips run together", at_s,
         max_fades, max_layers, max_active_clips);
}

void forget_from(LayerState &layer_state, double at_s)
{
    while (layer_state.fade_count > 0 && layer_state.fades[layer_state.fade_count - 1].at_s >= at_s) {
        Fade &last = layer_state.fades[--layer_state.fade_count];
        layer_state.now = last.from;
        last = Fade();
    }
}

void check_inertial(const LayerState &layer_state, const Source &to)
{
    bool inertial = false, gait = to.gait != none;
    for (uint32_t k = 0; k < layer_state.fade_count; ++k) {
        inertial = inertial || layer_state.fades[k].curve == Curve::inertial;
        gait = gait || layer_state.fades[k].from.gait != none;
    }
    if (inertial && gait)
        fail(CLQ_UNSUPPORTED, "an inertial fade goes from one clip to another: gaits fade by the other curves");
}

}  // namespace

void Crowd::change(uint32_t row, const LayerState &wanted)
{
    LayerState &there = layers_.make(row);
    const uint32_t link = there.next_free;
    there = wanted;
    there.next_free = link;
    plays_[row] = wanted.now.play;
    layers_.release_if_plain(row);
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

LayerState Crowd::layer_state_of(uint32_t row) const
{
    LayerState out;
    if (const LayerState *there = layers_.of(row)) out = *there;
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

void Crowd::restore_layer_state(uint32_t row, const LayerState &read)
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
    for (uint32_t k = 0; k < read.layer_count; ++k) check_layer(row, read.layers[k]);
    check_inertial(read, read.now);
    with_room(read, -never_s, [](LayerState &) { return true; });
    change(row, read);
}

void Crowd::play(Id id, const Source &source)
{
    const uint32_t row = row_of(id);
    LayerState wanted = layer_state_of(row);
    wanted.fade_count = 0;
    for (Fade &fade : wanted.fades) fade = Fade();
    wanted.now = source;
    wanted = with_room(wanted, -never_s, [](LayerState &) { return true; });
    change(row, wanted);
}

void Crowd::fade_to(Id id, const Source &source, double at_s, float length_s, Curve curve)
{
    const uint32_t row = row_of(id);
    check_moment(at_s);
    check_length("a fade", length_s);
    LayerState before = layer_state_of(row);
    forget_from(before, at_s);
    const LayerState wanted = with_room(before, at_s, [&](LayerState &to) {
        if (to.fade_count == max_fades) return false;
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
    LayerState wanted = layer_state_of(row);
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

void Crowd::check_layer(uint32_t row, const Layer &layer) const
{
    const model::Template &tmpl = template_of(row);
    check_play(layer.play, tmpl);
    Play reference;
    reference.clip = layer.reference_clip;
    check_play(reference, tmpl);
    check_moment(layer.start_s);
    if (!std::isfinite(layer.reference_time_s)) fail(CLQ_ARGUMENT, "the reference's time is not finite");
    check_length("a layer's fade in", layer.fade_in_s);
    check_length("a layer's fade out", layer.fade_out_s);
    if (!(layer.end_s >= layer.start_s))
        fail(CLQ_ARGUMENT, "a layer from %g s ends at %g s", layer.start_s, layer.end_s);
    if (layer.curve > Curve::inertial) fail(CLQ_ARGUMENT, "a layer of no curve");
    const float most = layer.additive ? max_layer_weight : 1;
    if (!(layer.weight <= most && layer.weight >= (layer.additive ? -max_layer_weight : 0)))
        fail(CLQ_ARGUMENT, "a layer's weight is %g: %g to %g is wanted", static_cast<double>(layer.weight),
             layer.additive ? -static_cast<double>(max_layer_weight) : 0.0, static_cast<double>(most));
    if (layer.curve == Curve::inertial) fail(CLQ_ARGUMENT, "a layer does not come in by inertia");
    if (layer.mask == none) return;
    if (layer.mask >= layers_.mask_count()) fail(CLQ_ARGUMENT, "mask %u of %u", layer.mask + 1, layers_.mask_count());
    if (layers_.mask(layer.mask).tmpl != &tmpl)
        fail(CLQ_ARGUMENT, "mask %u is of template '%s', the actor of '%s'", layer.mask + 1,
             layers_.mask(layer.mask).tmpl->name.c_str(), tmpl.name.c_str());
}

uint32_t Crowd::add_layer(Id id, const Layer &layer)
{
    const uint32_t row = row_of(id);
    check_layer(row, layer);
    LayerState wanted = with_room(layer_state_of(row), layer.start_s, [&](LayerState &to) {
        if (to.layer_count == max_layers) return false;
        to.layers[to.layer_count++] = layer;
        return true;
    });
    layers_.make(row);  // so that nothing fails once the name is given
    const uint32_t layer_id = layers_.next_layer_id();
    wanted.layers[wanted.layer_count - 1].layer_id = layer_id;
    change(row, wanted);
    return layer_id;
}

void Crowd::end_layer(Id id, uint32_t layer_id, double at_s, float fade_out_s)
{
    const uint32_t row = row_of(id);
    check_moment(at_s);
    check_length("a layer's fade out", fade_out_s);
    LayerState wanted = layer_state_of(row);
    for (uint32_t k = 0; k < wanted.layer_count; ++k) {
        Layer &layer = wanted.layers[k];
        if (layer.layer_id != layer_id) continue;
        const double end_s = at_s + static_cast<double>(fade_out_s);
        if (end_s < layer.end_s) {
            layer.end_s = end_s < layer.start_s ? layer.start_s : end_s;
            layer.fade_out_s = fade_out_s;
        }
        change(row, wanted);
        return;
    }
    fail(CLQ_STALE_ID, "the actor has no layer %u: it is over, and another has begun since", layer_id);
}

}  // namespace claque::crowd
