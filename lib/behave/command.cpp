#include "lib/behave/command.h"

#include <cmath>

#include "lib/base/error.h"
#include "lib/behave/mechanisms.h"
#include "lib/crowd/edits.h"

namespace claque::behave
{

using base::fail;

namespace
{

// [radians] A target that has moved by less, as seen by its actor, counts as the same one, and the turn to it
// continues.
constexpr double same_point = 0.09;

template <class Kind>
const Kind &kind_of(const crowd::Crowd &crowd, uint32_t mechanism, const char *name)
{
    const crowd::Behaviours &behaviours = crowd.behaviours();
    if (mechanism >= behaviours.mechanism_count())
        fail(CLQ_ARGUMENT, "mechanism %u does not exist: the crowd has %u", mechanism + 1,
             behaviours.mechanism_count());
    const Kind *kind = std::get_if<Kind>(&behaviours.mechanism(mechanism).kind);
    if (!kind) fail(CLQ_ARGUMENT, "mechanism %u is not of kind '%s'", mechanism + 1, name);
    return *kind;
}

void check_time(double at_s)
{
    if (!std::isfinite(at_s)) fail(CLQ_ARGUMENT, "a command begins at %g s: a finite time is wanted", at_s);
}

// A command for a time before the last command replaces that one.
void push_command(crowd::CommandHistory &history, const crowd::Command &command)
{
    if (command.at_s > history.at_s) history.before = history;
    if (command.at_s <= history.before.at_s) history.before = crowd::Command();
    static_cast<crowd::Command &>(history) = command;
}

glm::vec3 point_of(const crowd::Transform &transform, const glm::dvec3 &world)
{
    crowd::Transform target;
    target.position = world;
    const glm::dvec3 p = crowd::relative(transform, target).position;
    if (!(std::fabs(p.x) < 1e30 && std::fabs(p.y) < 1e30 && std::fabs(p.z) < 1e30))
        fail(CLQ_ARGUMENT, "a point to look at is (%g, %g, %g) from the actor: finite and less than 1e30 is wanted",
             p.x, p.y, p.z);
    return glm::vec3(p);
}

}  // namespace

void command_gaze(crowd::Crowd &crowd, crowd::Id id, uint32_t mechanism, const glm::dvec3 *point, double at_s)
{
    const uint32_t row = crowd.row_of(id);
    const crowd::Gaze &gaze = kind_of<crowd::Gaze>(crowd, mechanism, "gaze");
    check_time(at_s);
    crowd::Command command;
    command.at_s = at_s;
    if (point) {
        command.choice = 0;
        command.point =
            point_of(crowd.follows().of(row) ? crowd::reference_of(crowd, row, at_s) : crowd.transform_of(row), *point);
    }
    const double clock = clock_of(crowd.behaviours().attachment_of(row, mechanism), at_s);
    const RandomSlots random_slots = random_slots_of(crowd, row, mechanism, base::Purpose::gaze);
    crowd::CommandHistory &history = crowd::command_history(crowd, id, mechanism);
    const GazeDirection from = gaze_direction_at(gaze, random_slots, clock, history, crowd, row, at_s);
    command.from_yaw = static_cast<float>(from.yaw), command.from_pitch = static_cast<float>(from.pitch);
    if (point && history.choice == 0 && at_s >= history.at_s) {
        const GazeDirection last = target_of(gaze, random_slots, clock, history, crowd, row, at_s);
        command.side = static_cast<float>(last.yaw);
        const GazeDirection next = target_of(gaze, random_slots, clock, command, crowd, row, at_s);
        if (std::fabs(next.yaw - last.yaw) < same_point && std::fabs(next.pitch - last.pitch) < same_point) {
            history.point = command.point;
            history.side = command.side;
            return;
        }
    }
    command.side = command.from_yaw;
    push_command(history, command);
}

void command_expression(crowd::Crowd &crowd, crowd::Id id, uint32_t mechanism, uint32_t pose, double at_s)
{
    crowd.row_of(id);
    const crowd::Expression &expression = kind_of<crowd::Expression>(crowd, mechanism, "expression");
    check_time(at_s);
    if (pose != model::none && pose >= expression.poses.size())
        fail(CLQ_ARGUMENT, "pose %u does not exist: the expression has %zu", pose, expression.poses.size());
    crowd::CommandHistory &history = crowd::command_history(crowd, id, mechanism);
    crowd::Command command;
    command.at_s = at_s;
    command.choice = pose;
    command.choice_before = at_s > history.at_s ? history.choice : history.choice_before;
    push_command(history, command);
}

void command_phrase(crowd::Crowd &crowd, crowd::Id id, uint32_t mechanism, double at_s)
{
    crowd.row_of(id);
    kind_of<crowd::Phrase>(crowd, mechanism, "phrase");
    check_time(at_s);
    crowd::Command command;
    command.at_s = at_s;
    command.choice = 0;
    push_command(crowd::command_history(crowd, id, mechanism), command);
}

}  // namespace claque::behave
