// Fades, gaits, masks and layers (S2 3.3), and random clips (S0 7.1).
#include <claque/play.h>

#include <cmath>

#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"
#include "lib/api/play_def.h"
#include "lib/api/recorder.h"
#include "lib/base/hash.h"
#include "lib/behave/active_clips.h"
#include "lib/crowd/descriptions.h"
#include "lib/model/root_motion.h"

using namespace claque;

namespace
{

// The host's pointer may be to a destroyed template, so it is compared before it is dereferenced.
const model::Template &known(const clq_crowd *crowd, const clq_template *tmpl)
{
    api::require(tmpl != nullptr, "tmpl is NULL");
    api::require(crowd->crowd.has_template(*tmpl), "no actor of the crowd uses tmpl yet");
    return *tmpl;
}

double unit_sample(const crowd::Crowd &crowd, uint32_t row, base::Purpose purpose, uint32_t sample_index)
{
    return static_cast<double>(base::unit(base::hash(crowd.seed(), crowd.actor(row).seed, purpose, sample_index)));
}

uint32_t sampled_clip(const clq_random_play_def &def, double unit)
{
    if (!def.weights) return static_cast<uint32_t>(unit * def.clip_count);
    double sum = 0;
    for (uint32_t i = 0; i < def.clip_count; ++i) {
        const float weight = def.weights[i];
        if (!(weight >= 0) || !std::isfinite(weight))
            base::fail(CLQ_ARGUMENT, "the weight of clip %u is %g: 0 or more is wanted", i, double(weight));
        sum += double(weight);
    }
    if (!(sum > 0)) base::fail(CLQ_ARGUMENT, "the weights of all %u clips are 0", def.clip_count);
    double left = unit * sum;
    uint32_t chosen = 0;
    for (uint32_t i = 0; i < def.clip_count && left >= 0; ++i) {
        if (def.weights[i] > 0) chosen = i;
        left -= double(def.weights[i]);
    }
    return chosen;
}

void check_spread(const char *name, float spread, bool with_one)
{
    if (!(spread >= 0 && (with_one ? spread <= 1 : spread < 1)))
        base::fail(CLQ_ARGUMENT, "%s is %g: 0 to %s1 is wanted", name, double(spread), with_one ? "" : "less than ");
}

}  // namespace

extern "C" {

clq_status clq_crowd_add_gait(clq_crowd *crowd, const clq_gait_def *def, clq_gait *out)
{
    return api::boundary("clq_crowd_add_gait", [&] {
        api::require(crowd && def && out, "crowd, def or out is NULL");
        const clq_gait_def wanted = api::read_def(def, clq_gait_def_init, "clq_gait_def_init");
        const api::Busy busy(crowd);
        crowd::Gait made = api::gait_of(wanted, known(crowd, wanted.tmpl), &crowd->context->memory);
        const uint32_t index = crowd->crowd.layers().add(std::move(made));
        *out = {index + 1};
        api::changed_by(crowd, [&](api::Recorder &to) {
            to.description(record::Kind::crowd_add_gait,
                           [&](crowd::Writer &entry) { crowd::write_gait(entry, crowd->crowd.tables, index); });
        });
    });
}

clq_status clq_crowd_add_mask(clq_crowd *crowd, const clq_mask_def *def, clq_mask *out)
{
    return api::boundary("clq_crowd_add_mask", [&] {
        api::require(crowd && def && out, "crowd, def or out is NULL");
        const clq_mask_def wanted = api::read_def(def, clq_mask_def_init, "clq_mask_def_init");
        const api::Busy busy(crowd);
        crowd::MaskOf made = api::mask_of(wanted, known(crowd, wanted.tmpl), &crowd->context->memory);
        const uint32_t index = crowd->crowd.layers().add(std::move(made));
        *out = {index + 1};
        api::changed_by(crowd, [&](api::Recorder &to) {
            to.description(record::Kind::crowd_add_mask,
                           [&](crowd::Writer &entry) { crowd::write_mask(entry, crowd->crowd.tables, index); });
        });
    });
}

clq_status clq_actor_fade_to(clq_crowd *crowd, clq_actor actor, const clq_fade_def *def)
{
    return api::boundary("clq_actor_fade_to", [&] {
        api::require(crowd && def, "crowd or def is NULL");
        const clq_fade_def wanted = api::read_def(def, clq_fade_def_init, "clq_fade_def_init");
        const api::Busy busy(crowd);
        const uint32_t row = crowd->crowd.row_of(api::id_of(actor));
        const uint32_t gait = wanted.gait.index1 ? wanted.gait.index1 - 1 : model::none;
        const crowd::Source source = crowd::source(crowd->crowd, row, api::play_of(wanted.play), gait, wanted.share);
        crowd::fade_to(crowd->crowd, api::id_of(actor), source, wanted.at_s, wanted.length_s,
                       api::curve_of(wanted.curve));
        api::changed(crowd, record::ActorFadeTo{actor, wanted.play, wanted.gait.index1, wanted.share, wanted.at_s,
                                                wanted.length_s, api::number_of(wanted.curve)});
    });
}

clq_status clq_actor_set_gait_share(clq_crowd *crowd, clq_actor actor, float share, double at_s, float length_s)
{
    return api::boundary("clq_actor_set_gait_share", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd::change_share(crowd->crowd, api::id_of(actor), share, at_s, length_s);
        api::changed(crowd, record::ActorSetGaitShare{actor, share, at_s, length_s});
    });
}

clq_status clq_actor_add_layer(clq_crowd *crowd, clq_actor actor, const clq_layer_def *def, clq_layer *out)
{
    return api::boundary("clq_actor_add_layer", [&] {
        api::require(crowd && def, "crowd or def is NULL");
        const clq_layer_def wanted = api::read_def(def, clq_layer_def_init, "clq_layer_def_init");
        const api::Busy busy(crowd);
        const model::Template &tmpl = crowd->crowd.template_of(crowd->crowd.row_of(api::id_of(actor)));
        const uint32_t layer_id = crowd::add_layer(crowd->crowd, api::id_of(actor), api::layer_of(wanted, tmpl));
        if (out) *out = {layer_id};
        api::changed(crowd, record::ActorAddLayer{
                                actor, api::number_of(wanted.kind), wanted.play, wanted.weight, wanted.loops,
                                wanted.fade_in_s, wanted.fade_out_s, api::number_of(wanted.curve), wanted.mask.index1,
                                wanted.has_reference, wanted.reference_clip, wanted.reference_time_s, layer_id});
    });
}

clq_status clq_actor_end_layer(clq_crowd *crowd, clq_actor actor, clq_layer layer, double at_s, float fade_out_s)
{
    return api::boundary("clq_actor_end_layer", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd::end_layer(crowd->crowd, api::id_of(actor), layer.index1, at_s, fade_out_s);
        api::changed(crowd, record::ActorEndLayer{actor, layer.index1, at_s, fade_out_s});
    });
}

clq_status clq_actor_sample_play(const clq_crowd *crowd, clq_actor actor, const clq_random_play_def *def, clq_play *out)
{
    return api::boundary("clq_actor_sample_play", [&] {
        api::require(crowd && def && out, "crowd, def or out is NULL");
        const clq_random_play_def wanted = api::read_def(def, clq_random_play_def_init, "clq_random_play_def_init");
        const api::Reading reading(crowd);
        const uint32_t row = crowd->crowd.row_of(api::id_of(actor));
        const model::Template &tmpl = crowd->crowd.template_of(row);
        api::require(wanted.clip_count > 0 && wanted.clips,
                     "clips is NULL, or clip_count is 0: at least 1 clip is wanted");
        check_spread("speed_spread", wanted.speed_spread, false);
        check_spread("phase_spread", wanted.phase_spread, true);
        crowd::Play play;
        play.clip =
            wanted
                .clips[sampled_clip(wanted, unit_sample(crowd->crowd, row, base::Purpose::clip, wanted.sample_index))];
        play.start_s = wanted.start_s;
        const double speed = 2 * unit_sample(crowd->crowd, row, base::Purpose::speed, wanted.sample_index) - 1;
        play.speed = static_cast<float>(1 + speed * double(wanted.speed_spread));
        crowd::check_play(play, tmpl);
        if (play.clip != model::none)
            play.phase_s =
                static_cast<float>(unit_sample(crowd->crowd, row, base::Purpose::phase, wanted.sample_index) *
                                   double(wanted.phase_spread) * double(tmpl.rig.clips[play.clip].duration_s));
        *out = {play.clip, play.start_s, play.speed, play.phase_s};
    });
}

clq_status clq_actor_get_active_clips(const clq_crowd *crowd, clq_actor actor, double time_s,
                                      clq_active_clip out[CLQ_ACTIVE_CLIP_MAX], uint32_t *out_count)
{
    static_assert(CLQ_ACTIVE_CLIP_MAX == pose::max_layers && CLQ_ACTIVE_CLIP_MAX == crowd::max_active_clips,
                  "one limit");
    return api::boundary("clq_actor_get_active_clips", [&] {
        api::require(crowd && out && out_count, "crowd, out or out_count is NULL");
        if (!std::isfinite(time_s)) base::fail(CLQ_ARGUMENT, "time_s is not finite");
        const api::Reading reading(crowd);
        const uint32_t row = crowd->crowd.row_of(api::id_of(actor));
        const model::Level &level = crowd->crowd.template_of(row).levels[0];
        behave::ActiveClips shown;
        behave::active_clips_at(crowd->crowd, row, time_s, behave::mechanism_levels(crowd->crowd, row, 0, level),
                                shown);
        if (shown.count == 0) {
            out[0] = {shown.clip, shown.clip_time_s, 1, CLQ_LAYER_REPLACE};
            *out_count = 1;
            return;
        }
        for (uint32_t i = 0; i < shown.count; ++i) {
            const pose::Layer &layer = shown.layers[i];
            out[i] = {layer.clip, layer.time_s, layer.weight,
                      layer.kind == pose::LayerKind::add ? CLQ_LAYER_ADD : CLQ_LAYER_REPLACE};
        }
        *out_count = shown.count;
    });
}

clq_status clq_template_get_root_motion(const clq_template *tmpl, uint32_t clip, double from_s, double to_s,
                                        double out[3])
{
    return api::boundary("clq_template_get_root_motion", [&] {
        api::require(tmpl && out, "tmpl or out is NULL");
        if (clip >= tmpl->rig.clips.size())
            base::fail(CLQ_ARGUMENT, "clip %u does not exist: '%s' has %zu", clip, tmpl->name.c_str(),
                       tmpl->rig.clips.size());
        if (!std::isfinite(from_s) || !std::isfinite(to_s))
            base::fail(CLQ_ARGUMENT, "root motion from %g to %g s: finite times are wanted", from_s, to_s);
        const model::GroundTransform step = model::root_motion(tmpl->rig, clip, from_s, to_s);
        out[0] = step.x, out[1] = step.z, out[2] = step.yaw;
    });
}

clq_status clq_actor_set_watched(clq_crowd *crowd, clq_actor actor, bool watched)
{
    return api::boundary("clq_actor_set_watched", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd::watch(crowd->crowd, api::id_of(actor), watched);
        api::changed(crowd, record::ActorSetWatched{actor, watched});
    });
}

clq_status clq_crowd_get_events(clq_crowd *crowd, const clq_time_range *range, clq_event *out_events, size_t capacity,
                                size_t *out_count)
{
    return api::boundary("clq_crowd_get_events", [&] {
        api::require(crowd && range && out_count && (out_events || capacity == 0),
                     "crowd, range, out_events or out_count is NULL");
        const api::Busy busy(crowd);
        const double from_s = range->from_s, to_s = range->to_s;
        if (!std::isfinite(from_s) || !std::isfinite(to_s))
            base::fail(CLQ_ARGUMENT, "events from %g to %g s: finite times are wanted", from_s, to_s);
        model::Array<behave::Event> &found = crowd->events;
        behave::find_events(crowd->crowd, from_s, to_s, found);
        if (out_events && found.size() > capacity)
            base::fail(CLQ_LIMIT, "%zu events from %g to %g s: there is room for %zu", found.size(), from_s, to_s,
                       capacity);
        for (size_t i = 0; out_events && i < found.size(); ++i) {
            const behave::Event &e = found[i];
            const crowd::Id id = crowd->crowd.id_of(e.row);
            out_events[i] = {
                e.time_s, {id.index1, id.generation}, static_cast<clq_event_kind>(e.kind), e.clip, e.marker, e.round,
                {e.layer}};
        }
        *out_count = found.size();
    });
}

}  // extern "C"
