// Copies of an actor, its attached objects, callbacks and priority (S0 4.3, 5, 7.1).
#include <claque/behave.h>

#include <cmath>

#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"
#include "lib/api/recorder.h"
#include "lib/frame/node_matrix.h"

using namespace claque;

extern "C" {

clq_status clq_actor_clone(clq_crowd *crowd, clq_actor actor, const clq_transform *transform, uint64_t seed,
                           clq_actor *out)
{
    return api::boundary("clq_actor_clone", [&] {
        api::require(crowd && out, "crowd or out is NULL");
        const api::Busy busy(crowd);
        crowd::Transform wanted;
        if (transform) wanted = api::transform_of(*transform);
        const crowd::Id id = crowd::clone(crowd->crowd, api::id_of(actor), transform ? &wanted : nullptr, seed);
        const record::ActorClone made{
            actor, transform != nullptr, api::place_or_none(transform), seed, {id.index1, id.generation}};
        *out = made.made;
        api::changed(crowd, made);
    });
}

clq_status clq_actor_set_priority(clq_crowd *crowd, clq_actor actor, float priority)
{
    return api::boundary("clq_actor_set_priority", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd::set_priority(crowd->crowd, api::id_of(actor), priority);
        api::changed(crowd, record::ActorSetPriority{actor, priority});
    });
}

clq_status clq_actor_set_texture_set(clq_crowd *crowd, clq_actor actor, uint32_t set)
{
    return api::boundary("clq_actor_set_texture_set", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd::set_texture_set(crowd->crowd, api::id_of(actor), set);
        api::changed(crowd, record::ActorSetTextureSet{actor, set});
    });
}

clq_status clq_actor_attach(clq_crowd *crowd, clq_actor actor, const clq_attachment_def *def, clq_attachment *out)
{
    return api::boundary("clq_actor_attach", [&] {
        api::require(crowd && def, "crowd or def is NULL");
        const clq_attachment_def wanted = api::read_def(def, clq_attachment_def_init, "clq_attachment_def_init");
        const api::Busy busy(crowd);
        const model::Sphere sphere{glm::vec3(wanted.centre[0], wanted.centre[1], wanted.centre[2]), wanted.radius};
        const crowd::Id id = crowd::attach(crowd->crowd, api::id_of(actor), wanted.node, sphere);
        const float *c = wanted.centre;
        const record::ActorAttach made{
            actor, wanted.node, {c[0], c[1], c[2]}, wanted.radius, {id.index1, id.generation}};
        if (out) *out = made.made;
        api::changed(crowd, made);
    });
}

clq_status clq_actor_detach(clq_crowd *crowd, clq_attachment attachment)
{
    return api::boundary("clq_actor_detach", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd::detach(crowd->crowd, {attachment.index1, attachment.generation});
        api::changed(crowd, record::ActorDetach{attachment});
    });
}

clq_status clq_actor_get_node(clq_crowd *crowd, clq_actor actor, uint32_t node, double time_s, double out_matrix[16])
{
    return api::boundary("clq_actor_get_node", [&] {
        api::require(crowd && out_matrix, "crowd or out_matrix is NULL");
        const api::Busy busy(crowd);
        const uint32_t row = crowd->crowd.row_of(api::id_of(actor));
        const model::Template &tmpl = crowd->crowd.template_of(row);
        if (node >= tmpl.rig.node_count())
            base::fail(CLQ_ARGUMENT, "node %u does not exist: there are %u in template '%s'", node,
                       tmpl.rig.node_count(), tmpl.name.c_str());
        if (std::isinf(time_s)) base::fail(CLQ_ARGUMENT, "time_s is infinite");
        frame::node_world_matrix(crowd->crowd, crowd->frame, row, node, time_s, out_matrix);
    });
}

clq_status clq_actor_set_hooks(clq_crowd *crowd, clq_actor actor, const clq_actor_hooks *hooks)
{
    return api::boundary("clq_actor_set_hooks", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd::set_hooks(crowd->crowd, api::id_of(actor), hooks ? *hooks : clq_actor_hooks{nullptr, nullptr, nullptr});
    });
}

}  // extern "C"
