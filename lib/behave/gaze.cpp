// Gaze: spine, neck and eyes share the turn towards a target (S0 5.3).
#include <cmath>

#include "lib/behave/mechanisms.h"
#include "lib/math/eye_transform.h"
#include "lib/math/trig.h"

namespace claque::behave
{

namespace
{

constexpr double in_the_back = 2.6;  // [radians] of yaw, on either side

// The remaining yaw of a turn: it falls to 0 at pi, where the direction of the turn is undefined.
double let_go(double yaw)
{
    const double beyond = std::fabs(yaw) - in_the_back;
    return beyond > 0 ? yaw * (1 - ease(beyond, math::pi - in_the_back)) : yaw;
}

GazeDirection mixed(const GazeDirection &a, const GazeDirection &b, double by)
{
    return {a.yaw + (b.yaw - a.yaw) * by, a.pitch + (b.pitch - a.pitch) * by};
}

GazeDirection wandering(const crowd::Gaze &gaze, const RandomSlots &random_slots, double clock_s)
{
    const double often = static_cast<double>(gaze.wander_s);
    if (!(often > 0)) return GazeDirection();
    // The sum of two random numbers: mostly ahead.
    const auto target = [&](int64_t k) {
        return GazeDirection{
            (random_slots.unit(k, 0) + random_slots.unit(k, 1) - 1) * static_cast<double>(gaze.wander_yaw),
            (random_slots.unit(k, 2) + random_slots.unit(k, 3) - 1) * static_cast<double>(gaze.wander_pitch)};
    };
    const Slot slot = uneven_slot_at(clock_s, often, random_slots);
    const double turn = std::fmin(static_cast<double>(gaze.turn_s), 0.5 * often);
    return mixed(target(slot.index - 1), target(slot.index), ease(clock_s - slot.begin_s, turn));
}

// The remainder of a turn, part by part. A part takes its share as far as its range allows. A part that a coarse level
// omits, or whose node is deactivated, does not move but takes its share all the same, so that the others do not
// change.
struct Turn {
    const model::Rig &rig;
    Writer &writer;
    GazeDirection rest;

    double share(uint32_t dof, double wanted, bool moves)
    {
        if (dof == model::none) return 0;
        const float taken = clamped(rig.dofs[dof], static_cast<float>(wanted));
        if (moves) writer.write(dof, taken, 1);
        return static_cast<double>(taken);
    }
    void take(uint32_t yaw, uint32_t pitch, double part, bool moves, bool tilts)
    {
        rest.yaw -= share(yaw, part * rest.yaw, moves);
        rest.pitch -= share(pitch, part * rest.pitch, tilts);
    }
};

bool has(uint32_t a, uint32_t b) { return a != model::none || b != model::none; }

}  // namespace

GazeDirection target_of(const crowd::Gaze &gaze, const RandomSlots &random_slots, double clock_s,
                        const crowd::Command &command, const crowd::Crowd &crowd, uint32_t row, double time_s) noexcept
{
    if (command.choice == model::none) return wandering(gaze, random_slots, clock_s);
    const bool moves = crowd.behaviours().has_root_path_play(row);
    glm::dvec3 p(command.point);
    if (moves) {
        const crowd::Transform root = root_transform_at(crowd, row, time_s);
        p = (p - root.position) * math::rotation_of(root.orientation);  // the transpose rotates back
    }
    const glm::dvec3 v = p - glm::dvec3(gaze.eyes);
    const double level = std::sqrt(v.x * v.x + v.z * v.z), length = std::sqrt(level * level + v.y * v.y);
    GazeDirection direction{math::atan2(v.x, v.z), math::atan2(v.y, level)};
    // An actor on a path must not turn its head over at once when it passes a target. An actor at rest keeps the side
    // that it chose.
    if (moves) direction.yaw = let_go(direction.yaw);
    else if (std::fabs(direction.yaw) > in_the_back && static_cast<double>(command.side) * direction.yaw < 0)
        direction.yaw += direction.yaw < 0 ? 2 * math::pi : -2 * math::pi;
    // The yaw is undefined for a target straight above, so it fades in smoothly.
    direction.yaw *= ease(level, 0.17 * length);
    return direction;
}

GazeDirection gaze_direction_at(const crowd::Gaze &gaze, const RandomSlots &random_slots, double clock_s,
                                const crowd::CommandHistory &history, const crowd::Crowd &crowd, uint32_t row,
                                double time_s) noexcept
{
    const auto under = [&](const crowd::Command &command) {
        const double by = ease(time_s - command.at_s, static_cast<double>(gaze.turn_s));
        const GazeDirection from{static_cast<double>(command.from_yaw), static_cast<double>(command.from_pitch)};
        return mixed(from, target_of(gaze, random_slots, clock_s, command, crowd, row, time_s), by);
    };
    if (time_s >= history.at_s) return under(history);
    if (time_s >= history.before.at_s) return under(history.before);
    return wandering(gaze, random_slots, clock_s);
}

void run(const crowd::Gaze &gaze, const Call &call, Writer &writer) noexcept
{
    const GazeDirection direction =
        gaze_direction_at(gaze, call.random_slots(base::Purpose::gaze), call.clock_s(), call.command_history(),
                          call.crowd, call.row, call.context.time_s);
    // Each level omits the finest remaining part; the last part is kept without its pitch.
    const bool eyes = has(gaze.eye_yaw[0], gaze.eye_pitch[0]) || has(gaze.eye_yaw[1], gaze.eye_pitch[1]);
    const bool neck = has(gaze.neck_yaw, gaze.neck_pitch), spine = has(gaze.spine_yaw, gaze.spine_pitch);
    const uint32_t parts = uint32_t(eyes) + uint32_t(neck) + uint32_t(spine);
    const uint32_t left = call.level < parts ? parts - call.level : 1;
    const bool tilts = call.level < parts;
    const uint32_t with_neck = uint32_t(spine) + 1, with_eyes = with_neck + uint32_t(neck);
    Turn turn{*writer.rig, writer, direction};
    turn.take(gaze.spine_yaw, gaze.spine_pitch, static_cast<double>(gaze.spine_share), true, tilts);
    turn.take(gaze.neck_yaw, gaze.neck_pitch, static_cast<double>(gaze.neck_share), left >= with_neck,
              tilts && left >= with_neck);
    if (left < with_eyes) return;
    for (int k = 0; k < 2; ++k) {
        turn.share(gaze.eye_yaw[k], turn.rest.yaw, true);
        turn.share(gaze.eye_pitch[k], turn.rest.pitch, tilts);
    }
}

}  // namespace claque::behave
