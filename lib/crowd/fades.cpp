// Commands to play, fade and layer: each stores the state that it replaces, so that earlier times still show what was
// played then.
#include <algorithm>
#include <cmath>

#include "lib/base/error.h"
#include "lib/crowd/edits.h"
#include "lib/crowd/gait.h"
#include "lib/crowd/layer_rules.h"
#include "lib/crowd/rows.h"

namespace claque::crowd
{

using base::fail;
using model::none;

namespace
{

void forget_from(LayerState &layer_state, double at_s)
{
    while (layer_state.fade_count > 0 && layer_state.fades[layer_state.fade_count - 1].at_s >= at_s) {
        Fade &last = layer_state.fades[--layer_state.fade_count];
        layer_state.now = last.from;
        last = Fade();
    }
}

}  // namespace

LayerState layer_state_of(const Crowd &crowd, uint32_t row)
{
    LayerState out;
    if (const LayerState *there = crowd.layers().of(row)) out = *there;
    out.now.play = crowd.play_of(row);
    const Follow *follow = crowd.follows().of(row);
    if (follow && follow->walks) out.now.gait = track_gait;
    return out;
}

void change(Crowd &crowd, uint32_t row, const LayerState &wanted)
{
    Layers &layers = crowd.tables.layers;
    layers.make(row) = wanted;
    crowd.tables.actors.plays[row] = wanted.now.play;
    layers.release_if_plain(row);
    if (Follow *follow = crowd.tables.follows.of(row)) follow->walks = wanted.now.gait == track_gait;
    new_version(crowd, row);
    measure(crowd, row);
}

void watch(Crowd &crowd, Id id, bool watched) { set_watched(crowd.tables.actors, crowd.row_of(id), watched); }

void play(Crowd &crowd, Id id, const Play &play)
{
    const uint32_t row = crowd.row_of(id);
    const Source playing = source(crowd, row, play, none, 0);
    if (crowd.layers().of(row) || crowd.follows().of(row)) return claque::crowd::play(crowd, id, playing);
    crowd.tables.actors.plays[row] = play;
    new_version(crowd, row);
}

void play(Crowd &crowd, Id id, const Source &source)
{
    const uint32_t row = crowd.row_of(id);
    LayerState wanted = layer_state_of(crowd, row);
    wanted.fade_count = 0;
    for (Fade &fade : wanted.fades) fade = Fade();
    wanted.now = source;
    wanted = with_room(wanted, -never_s, [](LayerState &) { return true; });
    change(crowd, row, wanted);
}

void fade_to(Crowd &crowd, Id id, const Source &source, double at_s, float length_s, Curve curve)
{
    const uint32_t row = crowd.row_of(id);
    check_moment(at_s);
    check_length("a fade", length_s);
    LayerState before = layer_state_of(crowd, row);
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
    change(crowd, row, wanted);
}

void change_share(Crowd &crowd, Id id, float share, double at_s, float length_s)
{
    const uint32_t row = crowd.row_of(id);
    check_moment(at_s);
    check_length("a change of gait", length_s);
    check_share(share);
    LayerState wanted = layer_state_of(crowd, row);
    Source &now = wanted.now;
    if (now.gait >= track_gait) fail(CLQ_ARGUMENT, "the actor plays no gait of the crowd");
    const double rounds = rounds_at(crowd.tables.layers.gait(now.gait), now, at_s);
    if (!std::isfinite(rounds)) fail(CLQ_ARGUMENT, "at %g s the gait has no phase", at_s);
    now.share_from = share_at(now, at_s);
    now.change_rounds = rounds;
    now.change_s = at_s;
    now.share = share;
    now.change_length_s = length_s;
    change(crowd, row, wanted);
}

uint32_t add_layer(Crowd &crowd, Id id, const Layer &layer)
{
    const uint32_t row = crowd.row_of(id);
    check_layer(crowd, row, layer);
    LayerState wanted = with_room(layer_state_of(crowd, row), layer.start_s, [&](LayerState &to) {
        if (to.layer_count == max_layers) return false;
        to.layers[to.layer_count++] = layer;
        return true;
    });
    crowd.tables.layers.make(row);  // allocates now, so that nothing fails after the id is given
    const uint32_t layer_id = crowd.tables.layers.next_layer_id();
    wanted.layers[wanted.layer_count - 1].layer_id = layer_id;
    change(crowd, row, wanted);
    return layer_id;
}

void end_layer(Crowd &crowd, Id id, uint32_t layer_id, double at_s, float fade_out_s)
{
    const uint32_t row = crowd.row_of(id);
    check_moment(at_s);
    check_length("a layer's fade out", fade_out_s);
    LayerState wanted = layer_state_of(crowd, row);
    for (uint32_t k = 0; k < wanted.layer_count; ++k) {
        Layer &layer = wanted.layers[k];
        if (layer.layer_id != layer_id) continue;
        const double end_s = at_s + static_cast<double>(fade_out_s);
        if (end_s < layer.end_s) {
            layer.end_s = end_s < layer.start_s ? layer.start_s : end_s;
            layer.fade_out_s = fade_out_s;
        }
        change(crowd, row, wanted);
        return;
    }
    fail(CLQ_STALE_ID, "the actor has no layer %u: it is over, and another has begun since", layer_id);
}

}  // namespace claque::crowd
