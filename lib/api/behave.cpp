#include <claque/behave.h>

#include "lib/api/behave_def.h"
#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"
#include "lib/behave/command.h"
#include "lib/behave/writer.h"

using namespace claque;

extern "C" {

void clq_dof_write(clq_dof_writer *writer, uint32_t dof, float value, float weight)
{
    if (writer) writer->write(dof, value, weight);
}

clq_status clq_crowd_add_mechanism(clq_crowd *crowd, const clq_mechanism_def *def, clq_mechanism *out)
{
    return api::boundary("clq_crowd_add_mechanism", [&] {
        api::require(crowd && def && out, "crowd, def or out is NULL");
        api::require_size(def, "clq_mechanism_def_init");
        api::require(def->tmpl != nullptr, "tmpl is NULL");
        const api::Busy busy(crowd);
        // A host may hold on to a template that is gone, so it is looked for before it is looked at.
        api::require(crowd->crowd.has_template(*def->tmpl), "no actor of the crowd uses tmpl yet");
        model::Array<uint32_t> written(&crowd->context->memory);
        crowd::Mechanism made = api::mechanism_of(*def, *def->tmpl, &crowd->context->memory, written);
        const uint32_t index = crowd->crowd.behaviours().add(std::move(made), base::Span<const uint32_t>(written));
        *out = {index + 1};
    });
}

clq_status clq_actor_attach_mechanism(clq_crowd *crowd, clq_actor actor, const clq_mechanism_attachment *attachment)
{
    return api::boundary("clq_actor_attach_mechanism", [&] {
        api::require(crowd && attachment, "crowd or attachment is NULL");
        const api::Busy busy(crowd);
        crowd::MechanismAttachment wanted;
        wanted.mechanism = attachment->mechanism.index1 - 1;
        wanted.priority = attachment->priority;
        wanted.phase_s = attachment->phase_s;
        wanted.start_s = attachment->start_s;
        crowd->crowd.attach_mechanism(api::id_of(actor), wanted);
    });
}

clq_status clq_actor_detach_mechanism(clq_crowd *crowd, clq_actor actor, clq_mechanism mechanism)
{
    return api::boundary("clq_actor_detach_mechanism", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd->crowd.row_of(api::id_of(actor));
        if (mechanism.index1 - 1 >= crowd->crowd.behaviours().mechanism_count())
            base::fail(CLQ_ARGUMENT, "mechanism %u of %u", mechanism.index1,
                       crowd->crowd.behaviours().mechanism_count());
        crowd->crowd.detach_mechanism(api::id_of(actor), mechanism.index1 - 1);
    });
}

clq_status clq_actor_gaze(clq_crowd *crowd, clq_actor actor, clq_mechanism gaze, const double *point, double at_s)
{
    return api::boundary("clq_actor_gaze", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        const glm::dvec3 wanted = point ? glm::dvec3(point[0], point[1], point[2]) : glm::dvec3(0);
        behave::command_gaze(crowd->crowd, api::id_of(actor), gaze.index1 - 1, point ? &wanted : nullptr, at_s);
    });
}

clq_status clq_actor_express(clq_crowd *crowd, clq_actor actor, clq_mechanism expression, uint32_t shape, double at_s)
{
    return api::boundary("clq_actor_express", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        behave::command_expression(crowd->crowd, api::id_of(actor), expression.index1 - 1,
                                   shape == CLQ_NONE ? model::none : shape, at_s);
    });
}

clq_status clq_actor_say(clq_crowd *crowd, clq_actor actor, clq_mechanism phrase, double at_s)
{
    return api::boundary("clq_actor_say", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        behave::command_phrase(crowd->crowd, api::id_of(actor), phrase.index1 - 1, at_s);
    });
}

clq_status clq_crowd_add_root_path(clq_crowd *crowd, const clq_root_path_def *def, clq_root_path *out)
{
    return api::boundary("clq_crowd_add_root_path", [&] {
        api::require(crowd && def && out, "crowd, def or out is NULL");
        api::require_size(def, "clq_root_path_def_init");
        const api::Busy busy(crowd);
        *out = {crowd->crowd.behaviours().add(api::path_of(*def, &crowd->context->memory)) + 1};
    });
}

clq_status clq_actor_play_root_path(clq_crowd *crowd, clq_actor actor, const clq_root_path_play *motion)
{
    return api::boundary("clq_actor_play_root_path", [&] {
        api::require(crowd && motion, "crowd or motion is NULL");
        const api::Busy busy(crowd);
        crowd::RootPathPlay wanted;
        wanted.path = motion->path.index1 ? motion->path.index1 - 1 : model::none;
        wanted.speed = motion->speed;
        wanted.phase_s = motion->phase_s;
        wanted.start_s = motion->start_s;
        crowd->crowd.play_root_path(api::id_of(actor), wanted);
    });
}

clq_status clq_crowd_set_ground(clq_crowd *crowd, double (*height)(void *user, const double point[3]), void *user)
{
    return api::boundary("clq_crowd_set_ground", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd->crowd.set_ground(height, user);
    });
}

clq_status clq_actor_follow_ground(clq_crowd *crowd, clq_actor actor, float max_up, float max_down)
{
    return api::boundary("clq_actor_follow_ground", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd->crowd.follow_ground(api::id_of(actor), max_up, max_down);
    });
}

}  // extern "C"
