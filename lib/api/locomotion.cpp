// clq_locomotion: the clips that a template walks with.
#include <cmath>

#include "lib/api/boundary.h"
#include "lib/api/track_handle.h"

using namespace claque;

namespace claque::api
{

void release(const clq_locomotion *locomotion)
{
    if (--locomotion->holders == 0) unmake(locomotion->context, const_cast<clq_locomotion *>(locomotion));
}

}  // namespace claque::api

namespace
{

track::LocomotionClips clips_of(const clq_locomotion_def &def)
{
    track::LocomotionClips clips;
    clips.walk = def.walk, clips.run = def.run, clips.slow = def.slow_walk, clips.turn = def.turn;
    clips.torso = def.torso, clips.neck = def.neck, clips.head = def.head;
    if (def.idle_count > track::max_idles)
        base::fail(CLQ_ARGUMENT, "idle_count is %u: 0 to %u is wanted", def.idle_count, track::max_idles);
    api::require_array(def.idles, def.idle_count, "idles");
    clips.idle_count = def.idle_count;
    for (uint32_t i = 0; i < def.idle_count; ++i) clips.idles[i] = def.idles[i];
    for (int f = 0; f < 2; ++f) {
        const clq_leg_def &leg = def.legs[f];
        const uint32_t nodes[] = {leg.thigh, leg.shin, leg.foot, leg.toes};
        for (int part = 0; part < 4; ++part) clips.legs[f][part] = nodes[part];
    }
    return clips;
}

}  // namespace

extern "C" {

clq_status clq_locomotion_create(clq_context *context, const clq_locomotion_def *def, clq_locomotion **out)
{
    return api::boundary("clq_locomotion_create", [&] {
        api::require(context && def && out, "context, def or out is NULL");
        const clq_locomotion_def wanted = api::read_def(def, clq_locomotion_def_init, "clq_locomotion_def_init");
        api::require(wanted.tmpl != nullptr, "tmpl is NULL");
        api::require(wanted.tmpl->context == context, "tmpl is of another context");
        const track::LocomotionClips clips = clips_of(wanted);
        // The template is only held, never changed.
        api::Making<clq_locomotion> made(context, const_cast<clq_template *>(wanted.tmpl));
        track::measure(*wanted.tmpl, clips, *made);
        *out = made.release();
    });
}

void clq_locomotion_destroy(clq_locomotion *locomotion)
{
    if (locomotion) api::release(locomotion);
}

clq_status clq_locomotion_get_info(const clq_locomotion *locomotion, clq_locomotion_info *out)
{
    return api::boundary("clq_locomotion_get_info", [&] {
        api::require(locomotion && out, "locomotion or out is NULL");
        api::require_size(*out, "clq_locomotion_info_init");
        clq_locomotion_info info = clq_locomotion_info_init();
        info.walk_stride = locomotion->stride[track::walk_step];
        info.walk_speed = static_cast<float>(locomotion->walking_speed());
        if (locomotion->clips.run != model::none) {
            info.run_stride = locomotion->stride[track::gait_step_count - 1];
            info.run_speed = static_cast<float>(locomotion->running_speed());
        }
        if (locomotion->clips.slow != model::none) {
            info.slow_stride = locomotion->stride[track::slow_step];
            info.slow_speed = static_cast<float>(locomotion->slow_speed());
        }
        info.torso = locomotion->clips.torso, info.neck = locomotion->clips.neck, info.head = locomotion->clips.head;
        info.leg_length = locomotion->leg_length;
        for (int f = 0; f < 2; ++f) {
            const uint32_t *leg = locomotion->clips.legs[f];
            info.legs[f] = {leg[0], leg[1], leg[2], leg[3]};
        }
        api::write_out(out, info);
    });
}

}  // extern "C"
