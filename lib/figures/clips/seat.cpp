#include "lib/figures/clips/seat.h"

#include <glm/geometric.hpp>

#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/stance.h"
#include "lib/figures/mesh.h"

namespace claque::figures
{

namespace
{

constexpr glm::vec3 hips_on_seat(0, seat_height_m + 0.072f, -0.400f);  // midpoint of the thigh joints

// How the quarters of the skirt lie against a sitter's thighs, left side. The cloth of the lap sinks towards the knees,
// and the outer sides of the thighs push it up and out. The cloth below the thighs comes up to them. Both are pulled in
// at the hem, since a skirt is wider than both thighs together.
constexpr float lap_deg = 7.5f, lap_up_deg = 10, below_deg = -5.4f, lap_in_deg = 8, below_in_deg = 3;
constexpr glm::vec3 lap_shift(0.036f, 0, -0.030f), below_shift(0, 0.0205f, -0.050f);

void put_hips(Pose &pose, glm::vec3 hips, glm::quat pelvis)
{
    const glm::vec3 to_hips = skeleton().offset(Bone::thigh) * glm::vec3(0, 1, 1);
    pose.set(Bone::pelvis, pelvis);
    pose.shift_pelvis(hips - skeleton().joint(Bone::pelvis) - pelvis * to_hips);
}

}  // namespace

Pose posed(const Posture &p)
{
    Pose pose;
    put_hips(pose, hips_on_seat + p.hips, yaw(0.15f * p.twist) * roll(-0.12f * p.sway) * pitch(p.tilt));
    pose.set(Bone::spine, yaw(0.20f * p.twist) * roll(-0.30f * p.sway) * pitch(0.34f * p.bend));
    pose.set(Bone::spine_upper, yaw(0.30f * p.twist) * roll(-0.30f * p.sway) * pitch(0.36f * p.bend - 0.5f * p.breath));
    pose.set(Bone::chest, yaw(0.35f * p.twist) * roll(-0.28f * p.sway) * pitch(0.30f * p.bend - 0.9f * p.breath));
    const float up = p.nod - p.tilt - p.bend + 0.9f * p.breath;
    pose.set(Bone::neck, yaw(0.42f * p.look) * roll(-0.35f * p.cock) * pitch(0.42f * up));
    pose.set(Bone::head, yaw(0.58f * p.look) * roll(-0.65f * p.cock) * pitch(0.58f * up));
    pose.set(Side::left, Bone::clavicle, roll(1.1f * p.breath + p.shrug_l));
    pose.set(Side::right, Bone::clavicle, roll(1.1f * p.breath + p.shrug_r));
    for (const Side side : {Side::left, Side::right})
        stand_on(pose, side, {0.012f, side == Side::left ? 0.016f : -0.010f, 0, 1, 0, 5, p.knees_out});
    drape_lap(pose);
    return pose;
}

void drape_lap(Pose &pose)
{
    drape(pose);
    for (const Side side : {Side::left, Side::right}) {
        const glm::quat thigh = pose.local(on(side, Bone::thigh));
        const float down = (pose.world(on(side, Bone::thigh)) * glm::vec3(0, -1, 0)).y;
        const float raised = ease(-0.97f, -0.12f, down);
        // The cloth below the thighs lies on the edge of the seat until they have left it.
        const float lying = ease(-0.97f, -0.45f, down);
        // About the bone's own axes in its hanging orientation: Y runs along the thigh.
        const auto own = [side](glm::quat left) { return side == Side::left ? left : mirrored(left); };
        const glm::quat lap = roll(-lap_in_deg) * yaw(-lap_up_deg) * pitch(lap_deg);
        const glm::quat below = roll(-below_in_deg) * pitch(below_deg);
        const Bone front = on(side, Bone::skirt_front), back = on(side, Bone::skirt_back);
        pose.set(front, nlerp(pose.local(front), thigh * own(lap), raised));
        pose.set(back, nlerp(pose.local(back), thigh * own(below), lying));
        // The lap stays with the thighs whatever the lean of the pelvis.
        const auto stay = [&pose, side](Bone quarter, glm::vec3 by, float share) {
            const glm::vec3 own_place = skeleton().joint(quarter) - skeleton().joint(Bone::thigh) * glm::vec3(0, 1, 1);
            const glm::quat leant = glm::conjugate(pose.local(Bone::pelvis)) * pitch(Posture().tilt);
            pose.set_shift(quarter, (leant * (own_place + mirrored(by, side)) - own_place) * share);
        };
        stay(front, lap_shift, raised);
        stay(back, below_shift, lying);
    }
}

Grip in_lap(Side side)
{
    if (side == Side::left)
        return {{0.148f, 0.609f, -0.120f}, {-0.10f, -0.05f, 1}, {0.22f, 1, 0.10f}, {0.50f, -0.3f, -0.7f}, 0.03f};
    return {{0.144f, 0.606f, -0.145f}, {-0.24f, -0.06f, 1}, {0.16f, 1, 0.10f}, {0.52f, -0.3f, -0.6f}, 0.05f};
}

Pose seated(const Posture &posture, const Grip &left, const Grip &right)
{
    Pose pose = posed(posture);
    apply_grip(pose, Side::left, left);
    apply_grip(pose, Side::right, right);
    return pose;
}

}  // namespace claque::figures
