#include "lib/behave/active_clips.h"

#include "lib/behave/mechanisms.h"
#include "lib/crowd/gait.h"
#include "lib/pose/clock.h"

namespace claque::behave
{

using crowd::Curve;
using crowd::Source;
using pose::Layer;
using pose::LayerKind;

namespace
{

// The interval over which an inertial fade measures the velocity that it continues, as a fraction of its length. It is
// short enough for the present velocity and long enough that the weights of its continuation stay small
// (crowd::inertial_weight).
constexpr double look_back = 0.125;

double clip_time(const crowd::Crowd &crowd, uint32_t row, const crowd::Play &play, double time_s)
{
    if (play.clip == model::none) return 0;
    return pose::clip_time({play.start_s, play.speed, play.phase_s}, crowd.template_of(row).rig.clips[play.clip],
                           time_s);
}

class Stack
{
public:
    Stack(const crowd::Crowd &crowd, uint32_t row, double time_s, ActiveClips &out)
        : crowd_(crowd), row_(row), time_s_(time_s), out_(out)
    {
    }

    // Replaces what is below by a source, with `weight`.
    void replace(const Source &source, double weight)
    {
        const float rest = static_cast<float>(1 - weight);
        for (uint32_t f = 0; f < out_.foot_count; ++f) out_.feet[f].weight *= rest;
        out_.upper.gaze_rad *= rest, out_.upper.torso_rad *= rest;
        if (source.gait == crowd::track_gait) {
            replace_by_track(*crowd_.follows().of(row_), weight);
            return;
        }
        if (source.gait == model::none) {
            push(source.play.clip, clip_time(crowd_, row_, source.play, time_s_), weight);
            return;
        }
        const crowd::Gait &gait = crowd_.layers().gait(source.gait);
        const double rounds = rounds_at(gait, source, time_s_);
        const double both = weight * static_cast<double>(share_at(source, time_s_));
        // Two steps that together leave 1 - weight of what is below.
        if (both < 1) push(gait.clip_a, time_in_a(gait, rounds), 1 - (1 - weight) / (1 - both));
        push(gait.clip_b, time_in_b(gait, rounds), both);
    }

    // Adds the difference of two sources, each at a time of its own.
    void add(const crowd::Play &play, const crowd::Play &reference, double at_s, double weight)
    {
        if (weight == 0 || out_.count == pose::max_layers) return;
        Layer &layer = out_.layers[out_.count++];
        layer = Layer();
        layer.kind = LayerKind::add;
        layer.weight = static_cast<float>(weight);
        layer.clip = play.clip, layer.time_s = clip_time(crowd_, row_, play, at_s);
        layer.reference_clip = reference.clip, layer.reference_time_s = clip_time(crowd_, row_, reference, at_s);
    }

    void actor_layer(const crowd::Layer &actor_layer)
    {
        if (!(time_s_ >= actor_layer.start_s && time_s_ < actor_layer.end_s)) return;
        const double in =
            fade_weight(actor_layer.curve, time_s_ - actor_layer.start_s, static_cast<double>(actor_layer.fade_in_s));
        const double out =
            fade_weight(actor_layer.curve, actor_layer.end_s - time_s_, static_cast<double>(actor_layer.fade_out_s));
        const double weight = static_cast<double>(actor_layer.weight) * in * out;
        const uint32_t before = out_.count;
        push(actor_layer.play.clip, clip_time(crowd_, row_, actor_layer.play, time_s_), weight);
        if (out_.count == before) return;
        Layer &layer = out_.layers[before];
        if (actor_layer.mask != model::none) layer.mask = crowd_.layers().mask(actor_layer.mask).weights->data();
        if (!actor_layer.additive) return;
        layer.kind = LayerKind::add;
        layer.reference_clip = actor_layer.reference_clip, layer.reference_time_s = actor_layer.reference_time_s;
    }

    // The clips of the track's gait at its time, and its feet.
    void replace_by_track(const crowd::Follow &follow, double weight)
    {
        const double at_s = crowd::track_time(follow, time_s_);
        const track::Track &track = crowd::piece_at(follow, at_s);
        const track::State state = track::state_at(track, at_s);
        pose::Layer layers[3];
        const uint32_t count = track::layers_of(*track.locomotion, state.gait, state.turn, state.phase, state.idle,
                                                at_s + static_cast<double>(follow.offset_s), layers);
        double above = 1;  // of the layers that come later
        for (uint32_t k = count; k-- > 1;) above *= 1 - static_cast<double>(layers[k].weight);
        for (uint32_t k = 0; k < count; ++k) {
            // Steps that together leave 1 - weight of what is below.
            const double own = weight * static_cast<double>(layers[k].weight);
            if (k > 0) push(layers[k].clip, layers[k].time_s, own);
            else if (above > 0) push(layers[k].clip, layers[k].time_s, 1 - (1 - weight) / (1 - weight * (1 - above)));
        }
        out_.foot_count = 2;
        for (int f = 0; f < 2; ++f) {
            out_.feet[f] = track::foot_at(track, state, f, at_s);
            out_.feet[f].weight = static_cast<float>(weight);
        }
        out_.upper = track::upper_at(track, state, at_s);
        out_.upper.gaze_rad *= static_cast<float>(weight), out_.upper.torso_rad *= static_cast<float>(weight);
    }

private:
    void push(uint32_t clip, double clip_time_s, double weight)
    {
        if (weight == 0 || out_.count == pose::max_layers) return;
        Layer &layer = out_.layers[out_.count++];
        layer = Layer();
        layer.clip = clip, layer.time_s = clip_time_s, layer.weight = static_cast<float>(weight);
    }

    const crowd::Crowd &crowd_;
    const uint32_t row_;
    const double time_s_;
    ActiveClips &out_;
};

// What remains, during an inertial fade, of the difference at its start and of its velocity. The weights are
// polynomials that start with value 1 and slope 0, and with value 0 and slope 1, and end with value and slope 0
// (Bollo's inertialisation with a cubic). The velocity is measured from `look_back` before the start, so that both are
// differences of poses of the two clips.
void inertial(Stack &stack, const crowd::Play &from, const crowd::Play &to, const crowd::Fade &fade, double time_s)
{
    const double length = static_cast<double>(fade.length_s), x = (time_s - fade.at_s) / length;
    if (!(x < 1)) return;
    const double left = (1 - x) * (1 - x), offset = left * (1 + 2 * x), velocity = left * x / look_back;
    stack.add(from, to, fade.at_s, offset + velocity);
    stack.add(from, to, fade.at_s - look_back * length, -velocity);
}

struct FadeChain {
    const Source *sources[crowd::max_fades + 1];
    const crowd::Fade *fades[crowd::max_fades];  // [k]: from sources[k] to sources[k + 1]
    double weights[crowd::max_fades];
    uint32_t count = 0;  // fades that have begun
};

FadeChain fade_chain_of(const crowd::LayerState &layer_state, double time_s)
{
    FadeChain chain;
    while (chain.count < layer_state.fade_count && layer_state.fades[chain.count].at_s <= time_s) {
        const crowd::Fade &fade = layer_state.fades[chain.count];
        chain.sources[chain.count] = &fade.from;
        chain.fades[chain.count] = &fade;
        chain.weights[chain.count] = fade_weight(fade.curve, time_s - fade.at_s, static_cast<double>(fade.length_s));
        ++chain.count;
    }
    chain.sources[chain.count] =
        chain.count < layer_state.fade_count ? &layer_state.fades[chain.count].from : &layer_state.now;
    return chain;
}

// A finished cross-fade hides everything before it. The target of the last inertial fade is shown at once; the fades
// below it continue as differences on top.
void play(const crowd::LayerState &layer_state, double time_s, Stack &stack)
{
    const FadeChain chain = fade_chain_of(layer_state, time_s);
    uint32_t first = 0, base = 0;
    for (uint32_t k = 0; k < chain.count; ++k)
        if (chain.fades[k]->curve != Curve::inertial && chain.weights[k] >= 1) first = k + 1;
    base = first;
    for (uint32_t k = first; k < chain.count; ++k)
        if (chain.fades[k]->curve == Curve::inertial) base = k + 1;
    stack.replace(*chain.sources[base], 1);
    for (uint32_t k = first; k < base; ++k) {
        const crowd::Play &from = chain.sources[k]->play, &to = chain.sources[k + 1]->play;
        if (chain.fades[k]->curve == Curve::inertial) inertial(stack, from, to, *chain.fades[k], time_s);
        else stack.add(from, to, time_s, 1 - chain.weights[k]);
    }
    for (uint32_t k = base; k < chain.count; ++k) stack.replace(*chain.sources[k + 1], chain.weights[k]);
}

}  // namespace

double fade_weight(Curve curve, double gone_s, double length_s) noexcept
{
    if (curve == Curve::smooth) return ease(gone_s, length_s);
    if (gone_s >= length_s) return 1;
    return gone_s > 0 ? gone_s / length_s : 0;
}

void active_clips_at(const crowd::Crowd &crowd, uint32_t row, double time_s, MechanismLevels levels,
                     ActiveClips &out) noexcept
{
    const crowd::LayerState *layer_state = crowd.layers().of(row);
    const Plays plays = plays_at(crowd, row, time_s, levels);
    const crowd::Follow *follow = crowd.follows().of(row);
    const bool walks = follow && follow->walks && !plays.idle;
    out.count = out.foot_count = 0;
    out.upper = pose::UpperTarget();
    out.clip = plays.now.clip;
    out.clip_time_s = clip_time(crowd, row, plays.now, time_s);
    if (!layer_state && !walks && !(plays.weight < 1)) return;

    Stack stack(crowd, row, time_s, out);
    Source idle_source;
    if (plays.weight < 1) {
        idle_source.play = plays.before;
        stack.replace(idle_source, 1);
    }
    if (plays.idle) {
        idle_source.play = plays.now;
        stack.replace(idle_source, plays.weight);
    } else if (layer_state) {
        play(*layer_state, time_s, stack);
    } else {
        stack.replace_by_track(*follow, 1);
    }
    for (uint32_t k = 0; layer_state && k < layer_state->layer_count; ++k) stack.actor_layer(layer_state->layers[k]);
    if (out.count != 1) return;
    out.clip = out.layers[0].clip, out.clip_time_s = out.layers[0].time_s;
    out.count = 0;
}

}  // namespace claque::behave
