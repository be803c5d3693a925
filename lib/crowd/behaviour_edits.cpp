// Attaches mechanisms to actors, commands them, and sets how Skeleton Roots move (S0 5.3, 7.1).
#include <cmath>

#include "lib/base/error.h"
#include "lib/crowd/edits.h"
#include "lib/crowd/rows.h"

namespace claque::crowd
{

using base::fail;
using model::none;

void attach_mechanism(Crowd &crowd, Id id, const MechanismAttachment &attachment)
{
    const uint32_t row = crowd.row_of(id);
    Behaviours &behaviours = crowd.tables.behaviours;
    if (attachment.mechanism >= behaviours.mechanism_count())
        fail(CLQ_ARGUMENT, "mechanism %u does not exist: the crowd has %u", attachment.mechanism + 1,
             behaviours.mechanism_count());
    const model::Template *tmpl = behaviours.mechanism(attachment.mechanism).tmpl;
    if (tmpl != &crowd.template_of(row))
        fail(CLQ_ARGUMENT, "mechanism %u is of template '%s', the actor of '%s'", attachment.mechanism + 1,
             tmpl ? tmpl->name.c_str() : "(none)", crowd.template_of(row).name.c_str());
    if (!std::isfinite(attachment.priority) || !std::isfinite(attachment.phase_s) || !std::isfinite(attachment.start_s))
        fail(CLQ_ARGUMENT,
             "priority, phase and start of a mechanism's attachment are %g, %g and %g: they must be finite",
             double(attachment.priority), double(attachment.phase_s), attachment.start_s);
    behaviours.attach_mechanism(row, attachment);
    new_version(crowd, row);
    measure(crowd, row);
}

void detach_mechanism(Crowd &crowd, Id id, uint32_t mechanism)
{
    const uint32_t row = crowd.row_of(id);
    crowd.tables.behaviours.detach_mechanism(row, mechanism);
    new_version(crowd, row);
    measure(crowd, row);
}

CommandHistory &command_history(Crowd &crowd, Id id, uint32_t mechanism)
{
    const uint32_t row = crowd.row_of(id);
    CommandHistory &command_history = crowd.tables.behaviours.command_history(row, mechanism);
    new_version(crowd, row);
    return command_history;
}

void play_root_path(Crowd &crowd, Id id, const RootPathPlay &root_play)
{
    const uint32_t row = crowd.row_of(id);
    Behaviours &behaviours = crowd.tables.behaviours;
    if (root_play.path != none && root_play.path >= behaviours.path_count())
        fail(CLQ_ARGUMENT, "path %u does not exist: the crowd has %u", root_play.path + 1, behaviours.path_count());
    if (!std::isfinite(root_play.speed) || !std::isfinite(root_play.phase_s) || !std::isfinite(root_play.start_s))
        fail(CLQ_ARGUMENT, "speed, phase and start of a root path are %g, %g and %g: they must be finite",
             static_cast<double>(root_play.speed), static_cast<double>(root_play.phase_s), root_play.start_s);
    behaviours.play_root_path(row, root_play);
    new_version(crowd, row);
    measure(crowd, row);
}

}  // namespace claque::crowd
