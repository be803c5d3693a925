#include "lib/crowd/layer_rules.h"

#include <cmath>

#include "lib/base/error.h"
#include "lib/crowd/edits.h"
#include "lib/crowd/gait.h"

namespace claque::crowd
{

using base::fail;
using model::none;

void check_play(const Play &play, const model::Template &tmpl)
{
    if (play.clip != none && play.clip >= tmpl.rig.clips.size())
        fail(CLQ_ARGUMENT, "clip %u does not exist: there are %zu in template '%s'", play.clip, tmpl.rig.clips.size(),
             tmpl.name.c_str());
    if (!std::isfinite(play.start_s) || !std::isfinite(play.speed) || !std::isfinite(play.phase_s))
        fail(CLQ_ARGUMENT, "start, speed and phase of a clip are %g, %g and %g: they must be finite", play.start_s,
             double(play.speed), double(play.phase_s));
}

void check_length(const char *what, float length_s)
{
    if (!(length_s >= 0) || !std::isfinite(length_s))
        fail(CLQ_ARGUMENT, "%s of %g s: 0 or more is wanted", what, static_cast<double>(length_s));
}

void check_moment(double at_s)
{
    if (!std::isfinite(at_s)) fail(CLQ_ARGUMENT, "a command begins at %g s: a finite time is wanted", at_s);
}

void check_share(float share)
{
    if (!(share >= 0 && share <= 1))
        fail(CLQ_ARGUMENT, "a share of %g of the second gait: 0 to 1 is wanted", static_cast<double>(share));
}

Source source(const Crowd &crowd, uint32_t row, const Play &play, uint32_t gait, float share)
{
    Source out;
    out.play = play;
    const model::Template &tmpl = crowd.template_of(row);
    if (gait == track_gait) {
        if (!crowd.follows().of(row)) fail(CLQ_ARGUMENT, "an actor that follows no track plays the gait of one");
        out.gait = gait;
    } else if (gait != none) {
        if (gait >= crowd.layers().gait_count())
            fail(CLQ_ARGUMENT, "gait %u does not exist: the crowd has %u", gait + 1, crowd.layers().gait_count());
        const Gait &of = crowd.layers().gait(gait);
        if (of.tmpl != &tmpl)
            fail(CLQ_ARGUMENT, "gait %u is of template '%s', the actor of '%s'", gait + 1, of.tmpl->name.c_str(),
                 tmpl.name.c_str());
        check_share(share);
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

void check_source(const Crowd &crowd, uint32_t row, const Source &read)
{
    const Source made = source(crowd, row, read.play, read.gait, read.share);
    const bool gait = made.gait >= track_gait || made.play.clip == read.play.clip;
    if (!gait || !(read.share_from >= 0 && read.share_from <= 1) || !std::isfinite(read.change_s) ||
        !std::isfinite(read.change_rounds))
        fail(CLQ_ARGUMENT, "a gait that no command leads to");
    check_length("a change of gait", read.change_length_s);
}

void check_layer(const Crowd &crowd, uint32_t row, const Layer &layer)
{
    const model::Template &tmpl = crowd.template_of(row);
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
    const float maximum = layer.additive ? max_layer_weight : 1;
    if (!(layer.weight <= maximum && layer.weight >= (layer.additive ? -max_layer_weight : 0)))
        fail(CLQ_ARGUMENT, "a layer's weight is %g: %g to %g is wanted", static_cast<double>(layer.weight),
             layer.additive ? -static_cast<double>(max_layer_weight) : 0.0, static_cast<double>(maximum));
    if (layer.curve == Curve::inertial) fail(CLQ_ARGUMENT, "a layer does not come in by inertia");
    if (layer.mask == none) return;
    if (layer.mask >= crowd.layers().mask_count())
        fail(CLQ_ARGUMENT, "mask %u does not exist: the crowd has %u", layer.mask + 1, crowd.layers().mask_count());
    if (crowd.layers().mask(layer.mask).tmpl != &tmpl)
        fail(CLQ_ARGUMENT, "mask %u is of template '%s', the actor of '%s'", layer.mask + 1,
             crowd.layers().mask(layer.mask).tmpl->name.c_str(), tmpl.name.c_str());
}

void check_inertial(const LayerState &layer_state, const Source &to)
{
    bool inertial = false, gait = to.gait != none;
    for (uint32_t k = 0; k < layer_state.fade_count; ++k) {
        inertial = inertial || layer_state.fades[k].curve == Curve::inertial;
        gait = gait || layer_state.fades[k].from.gait != none;
    }
    if (inertial && gait)
        fail(CLQ_UNSUPPORTED, "an inertial fade needs one clip on both sides: gaits need the linear or smooth curve");
}

void check_layering(const Crowd &crowd, uint32_t row, const LayerState &layer_state)
{
    check_source(crowd, row, layer_state.now);
    for (uint32_t k = 0; k < layer_state.fade_count; ++k) {
        const Fade &fade = layer_state.fades[k];
        check_source(crowd, row, fade.from);
        check_moment(fade.at_s);
        check_length("a fade", fade.length_s);
        if (fade.curve > Curve::inertial || (k > 0 && !(layer_state.fades[k - 1].at_s < fade.at_s)))
            fail(CLQ_ARGUMENT, "a fade that no command leads to");
    }
    for (uint32_t k = 0; k < layer_state.layer_count; ++k) check_layer(crowd, row, layer_state.layers[k]);
    check_inertial(layer_state, layer_state.now);
    with_room(layer_state, -never_s, [](LayerState &) { return true; });
}

void forget_before(LayerState &layer_state, double at_s)
{
    // Under an inertial fade the earlier fades continue as a difference until they end; a finished cross-fade hides all
    // before it.
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

void refuse_layers(double at_s)
{
    fail(CLQ_LIMIT,
         "no room for what begins at %g s: of one actor at most %u fades, %u layers and %u clips run together", at_s,
         max_fades, max_layers, max_active_clips);
}

}  // namespace claque::crowd
