// Control mechanisms, their commands, root paths and the ground.
#include <claque/behave.h>

#include "lib/api/behave_def.h"
#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"
#include "lib/api/recorder.h"
#include "lib/behave/command.h"
#include "lib/behave/writer.h"
#include "lib/crowd/descriptions.h"

using namespace claque;

extern "C" {

void clq_dof_write(clq_dof_writer *writer, uint32_t dof, float value, float weight)
{
    if (writer) base::with_own_floats([&] { writer->write(dof, value, weight); });
}

clq_status clq_crowd_add_mechanism(clq_crowd *crowd, const clq_mechanism_def *def, clq_mechanism *out)
{
    return api::boundary("clq_crowd_add_mechanism", [&] {
        api::require(crowd && def && out, "crowd, def or out is NULL");
        const clq_mechanism_def wanted = api::read_def(def, clq_mechanism_def_init, "clq_mechanism_def_init");
        api::require(wanted.tmpl != nullptr, "tmpl is NULL");
        const api::Busy busy(crowd);
        // The host's pointer may be to a destroyed template, so it is compared before it is dereferenced.
        api::require(crowd->crowd.has_template(*wanted.tmpl), "no actor of the crowd uses tmpl yet");
        model::Array<uint32_t> written(&crowd->context->memory);
        crowd::Mechanism made = api::mechanism_of(wanted, *wanted.tmpl, &crowd->context->memory, written);
        const uint32_t index = crowd->crowd.behaviours().add(std::move(made), base::Span<const uint32_t>(written));
        *out = {index + 1};
        api::changed_by(crowd, [&](api::Recorder &to) {
            to.description(record::Kind::crowd_add_mechanism,
                           [&](crowd::Writer &entry) { crowd::write_mechanism(entry, crowd->crowd.tables, index); });
        });
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
        crowd::attach_mechanism(crowd->crowd, api::id_of(actor), wanted);
        api::changed(crowd, record::ActorAttachMechanism{actor, attachment->mechanism.index1, attachment->priority,
                                                         attachment->phase_s, attachment->start_s});
    });
}

clq_status clq_actor_detach_mechanism(clq_crowd *crowd, clq_actor actor, clq_mechanism mechanism)
{
    return api::boundary("clq_actor_detach_mechanism", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd->crowd.row_of(api::id_of(actor));
        if (mechanism.index1 - 1 >= crowd->crowd.behaviours().mechanism_count())
            base::fail(CLQ_ARGUMENT, "mechanism %u does not exist: the crowd has %u", mechanism.index1,
                       crowd->crowd.behaviours().mechanism_count());
        crowd::detach_mechanism(crowd->crowd, api::id_of(actor), mechanism.index1 - 1);
        api::changed(crowd, record::ActorDetachMechanism{actor, mechanism.index1});
    });
}

clq_status clq_actor_gaze(clq_crowd *crowd, clq_actor actor, clq_mechanism gaze, const double *point, double at_s)
{
    return api::boundary("clq_actor_gaze", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        const glm::dvec3 wanted = point ? glm::dvec3(point[0], point[1], point[2]) : glm::dvec3(0);
        behave::command_gaze(crowd->crowd, api::id_of(actor), gaze.index1 - 1, point ? &wanted : nullptr, at_s);
        api::changed(crowd,
                     record::ActorGaze{actor, gaze.index1, point != nullptr, {wanted.x, wanted.y, wanted.z}, at_s});
    });
}

clq_status clq_actor_express(clq_crowd *crowd, clq_actor actor, clq_mechanism expression, uint32_t pose, double at_s)
{
    return api::boundary("clq_actor_express", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        behave::command_expression(crowd->crowd, api::id_of(actor), expression.index1 - 1,
                                   pose == CLQ_NONE ? model::none : pose, at_s);
        api::changed(crowd, record::ActorExpress{actor, expression.index1, pose, at_s});
    });
}

clq_status clq_actor_say(clq_crowd *crowd, clq_actor actor, clq_mechanism phrase, double at_s)
{
    return api::boundary("clq_actor_say", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        behave::command_phrase(crowd->crowd, api::id_of(actor), phrase.index1 - 1, at_s);
        api::changed(crowd, record::ActorSay{actor, phrase.index1, at_s});
    });
}

clq_status clq_crowd_add_root_path(clq_crowd *crowd, const clq_root_path_def *def, clq_root_path *out)
{
    return api::boundary("clq_crowd_add_root_path", [&] {
        api::require(crowd && def && out, "crowd, def or out is NULL");
        const clq_root_path_def wanted = api::read_def(def, clq_root_path_def_init, "clq_root_path_def_init");
        const api::Busy busy(crowd);
        const uint32_t index = crowd->crowd.behaviours().add(api::path_of(wanted, &crowd->context->memory));
        *out = {index + 1};
        api::changed_by(crowd, [&](api::Recorder &to) {
            to.description(record::Kind::crowd_add_root_path,
                           [&](crowd::Writer &entry) { crowd::write_path(entry, crowd->crowd.tables, index); });
        });
    });
}

clq_status clq_actor_play_root_path(clq_crowd *crowd, clq_actor actor, const clq_root_path_play *play)
{
    return api::boundary("clq_actor_play_root_path", [&] {
        api::require(crowd && play, "crowd or play is NULL");
        const api::Busy busy(crowd);
        crowd::RootPathPlay wanted;
        wanted.path = play->path.index1 ? play->path.index1 - 1 : model::none;
        wanted.speed = play->speed;
        wanted.phase_s = play->phase_s;
        wanted.start_s = play->start_s;
        crowd::play_root_path(crowd->crowd, api::id_of(actor), wanted);
        api::changed(crowd,
                     record::ActorPlayRootPath{actor, play->path.index1, play->speed, play->phase_s, play->start_s});
    });
}

clq_status clq_crowd_set_ground(clq_crowd *crowd, clq_height_function height, void *user)
{
    return api::boundary("clq_crowd_set_ground", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd::set_ground(crowd->crowd, height, user);
    });
}

clq_status clq_actor_follow_ground(clq_crowd *crowd, clq_actor actor, float max_up, float max_down)
{
    return api::boundary("clq_actor_follow_ground", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd::follow_ground(crowd->crowd, api::id_of(actor), max_up, max_down);
        api::changed(crowd, record::ActorFollowGround{actor, max_up, max_down});
    });
}

}  // extern "C"
