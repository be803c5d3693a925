// clq_actor_...: actors, what they play, their colours, and what they show.
#include <claque/crowd.h>

#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"
#include "lib/api/recorder.h"
#include "lib/api/template_def.h"

using namespace claque;

namespace claque::api
{

crowd::Transform transform_of(const clq_transform &transform)
{
    crowd::Transform out;
    out.position = glm::dvec3(transform.position[0], transform.position[1], transform.position[2]);
    const float *q = transform.orientation_xyzw;
    if (q[0] != 0 || q[1] != 0 || q[2] != 0 || q[3] != 0) out.orientation = glm::quat(q[3], q[0], q[1], q[2]);
    if (transform.scale != 0) out.scale = transform.scale;
    return out;
}

clq_transform transform_of(const crowd::Transform &transform)
{
    clq_transform out{};
    for (int k = 0; k < 3; ++k) out.position[k] = transform.position[k];
    const glm::quat &q = transform.orientation;
    out.orientation_xyzw[0] = q.x, out.orientation_xyzw[1] = q.y;
    out.orientation_xyzw[2] = q.z, out.orientation_xyzw[3] = q.w;
    out.scale = transform.scale;
    return out;
}

crowd::Play play_of(const clq_play &play) { return {play.clip, play.start_s, play.speed, play.phase_s}; }

}  // namespace claque::api

namespace
{

// Retains a template that a crowd is about to use for the first time, and releases it unless `keep` is called.
class NewTemplate
{
public:
    NewTemplate(clq_crowd *crowd, clq_template *tmpl) : crowd_(crowd)
    {
        if (crowd->crowd.has_template(*tmpl)) return;
        crowd->held.push_back(tmpl);
        api::hold(tmpl);
        held_ = true;
    }
    NewTemplate(const NewTemplate &) = delete;
    NewTemplate &operator=(const NewTemplate &) = delete;
    ~NewTemplate()
    {
        if (!held_) return;
        api::release(crowd_->held.back());
        crowd_->held.pop_back();
    }
    void keep() { held_ = false; }

private:
    clq_crowd *crowd_;
    bool held_ = false;
};

}  // namespace

extern "C" {

clq_status clq_actor_create(clq_crowd *crowd, const clq_actor_def *def, clq_actor *out)
{
    return api::boundary("clq_actor_create", [&] {
        api::require(crowd && def && out, "crowd, def or out is NULL");
        const clq_actor_def wanted = api::read_def(def, clq_actor_def_init, "clq_actor_def_init");
        api::require(wanted.tmpl != nullptr, "tmpl is NULL");
        api::require(wanted.tmpl->context == crowd->context, "the template was made from another context");
        if (wanted.texture_set != CLQ_RANDOM && wanted.texture_set >= wanted.tmpl->texture_set_count())
            base::fail(CLQ_ARGUMENT, "texture set %u does not exist: template '%s' has %u", wanted.texture_set,
                       wanted.tmpl->name.c_str(), wanted.tmpl->texture_set_count());
        const api::Busy busy(crowd);
        NewTemplate held(crowd, wanted.tmpl);
        const crowd::Id id = crowd::create(crowd->crowd, *wanted.tmpl, api::transform_of(wanted.transform),
                                           api::play_of(wanted.play), wanted.seed);
        crowd::set_texture_set(crowd->crowd, id, wanted.texture_set);
        held.keep();
        const clq_actor made = {id.index1, id.generation};
        *out = made;
        api::changed_by(crowd, [&](api::Recorder &to) { to.create(wanted, made); });
    });
}

clq_status clq_actor_destroy(clq_crowd *crowd, clq_actor actor)
{
    return api::boundary("clq_actor_destroy", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd::destroy(crowd->crowd, api::id_of(actor));
        api::changed(crowd, record::ActorDestroy{actor});
    });
}

clq_status clq_actor_play(clq_crowd *crowd, clq_actor actor, const clq_play *play)
{
    return api::boundary("clq_actor_play", [&] {
        api::require(crowd && play, "crowd or play is NULL");
        const api::Busy busy(crowd);
        crowd::play(crowd->crowd, api::id_of(actor), api::play_of(*play));
        api::changed(crowd, record::ActorPlay{actor, *play});
    });
}

clq_status clq_actor_set_colours(clq_crowd *crowd, clq_actor actor, const float *rgb, uint32_t zone_count)
{
    return api::boundary("clq_actor_set_colours", [&] {
        api::require(crowd && rgb, "crowd or rgb is NULL");
        const api::Busy busy(crowd);
        crowd::set_colours(crowd->crowd, api::id_of(actor), rgb, zone_count);
        api::changed_by(crowd, [&](api::Recorder &to) { to.colours(&actor, 1); });
    });
}

clq_status clq_actor_randomise_colours(clq_crowd *crowd, clq_actor actor, const clq_hsb_range *ranges,
                                       uint32_t zone_count)
{
    return api::boundary("clq_actor_randomise_colours", [&] {
        api::require(crowd && (ranges || zone_count == 0), "crowd or ranges is NULL");
        const api::Busy busy(crowd);
        std::pmr::vector<model::HsbRange> wanted(&crowd->context->memory);
        wanted.reserve(zone_count);
        for (uint32_t i = 0; i < zone_count; ++i) wanted.push_back(api::range_of(ranges[i]));
        crowd::randomise_colours(crowd->crowd, api::id_of(actor), wanted.data(), zone_count);
        api::changed_by(crowd, [&](api::Recorder &to) { to.colours(&actor, 1); });
    });
}

clq_status clq_actor_get_info(const clq_crowd *crowd, clq_actor actor, clq_actor_info *out)
{
    return api::boundary("clq_actor_get_info", [&] {
        api::require(crowd && out, "crowd or out is NULL");
        api::require_size(*out, "clq_actor_info_init");
        const api::Reading reading(crowd);
        const uint32_t row = crowd->crowd.row_of(api::id_of(actor));
        const crowd::Play &play = crowd->crowd.play_of(row);
        const frame::ActorVisibility visibility = crowd->frame.visibility(crowd->crowd, row);
        clq_actor_info info = clq_actor_info_init();
        info.tmpl = static_cast<const clq_template *>(&crowd->crowd.template_of(row));
        info.transform = api::transform_of(crowd->crowd.transform_of(row));
        if (const uint32_t group = crowd->crowd.group_of(row); group != model::none)
            info.group = {group + 1, crowd->crowd.group(group).generation};
        info.play = {play.clip, play.start_s, play.speed, play.phase_s};
        info.seed = crowd->crowd.actor(row).seed;
        info.texture_set = crowd->crowd.actor(row).texture_set;
        info.visible = visibility.visible;
        info.period_s = visibility.period_s;
        info.tick_s = visibility.shown_s;
        info.priority = crowd->crowd.extent_of(row).priority;
        info.eye_distance_m = visibility.distance * crowd->frame.settings().caches.metres_per_unit;
        info.level = visibility.level;
        crowd::Transform root;
        if (!crowd->frame.root_of(crowd->crowd, row, root)) root = crowd->crowd.world_transform_of(row);
        info.root = api::transform_of(root);
        info.refpoint_radius = crowd->crowd.extent_of(row).refpoint;
        info.sklsroot_radius = crowd->crowd.extent_of(row).sklsroot;
        api::write_out(out, info);
    });
}

}  // extern "C"
