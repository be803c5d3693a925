// Applauding and cheering on one's feet for a while: from `stand` into the movements of applaud and cheer, and back.
// The feet stay in place, and the elbows keep clear of neighbours on either side.
#include <cmath>

#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/grip.h"
#include "lib/figures/clips/stance.h"
#include "lib/math/trig.h"

namespace claque::figures
{

namespace
{

// Trunk, head and cloth of one pose interpolated towards another; the arms stay those of the first.
Pose between_poses(const Pose &from, const Pose &to, float share, float heels_deg)
{
    Pose pose = from;
    for (const Bone bone : {Bone::pelvis, Bone::spine, Bone::spine_upper, Bone::chest, Bone::neck, Bone::head,
                            Bone::clavicle, Bone::clavicle_r})
        pose.set(bone, nlerp(from.local(bone), to.local(bone), share));
    pose.shift_pelvis(from.shift(Bone::pelvis) + (to.shift(Bone::pelvis) - from.shift(Bone::pelvis)) * share);
    for (const Side side : {Side::left, Side::right})
        stand_on(pose, side, {0.012f, side == Side::left ? 0.016f : -0.010f, share * heels_deg, 1, 0, 5});
    drape(pose);
    return pose;
}

float loop(float phase, int loops)
{
    return phase * static_cast<float>(loops) - std::floor(phase * static_cast<float>(loops));
}

Grip thrust(float up)
{
    const Grip low = {{0.215f, 1.640f, 0.200f}, {0.05f, 1, 0.10f}, {0.55f, 0.05f, -0.83f}, {0.25f, -0.8f, 0.75f}, 1};
    const Grip high = {{0.205f, 1.920f, 0.090f}, {0.02f, 1, 0.05f}, {0.55f, 0.05f, -0.83f}, {0.25f, -0.6f, 0.75f}, 1};
    return mix(low, high, up);
}

}  // namespace

Pose stand_applaud_at(float phase)
{
    const float share = hold(phase, 0.02f, 0.18f, 0.82f, 0.98f), within = loop(phase, 2);
    Pose pose = between_poses(stand_at(phase), applaud_at(within), share, 0);
    const float s = math::sin(6 * pi * within);
    Grip clap = clapping(s * s, glm::vec3(0, 1.245f, 0.345f));
    clap.pole = glm::vec3(0.45f, -1, -0.20f);
    for (const Side side : {Side::left, Side::right}) blend_to_grip(pose, side, clap, share, {0, 0, 0.04f}, 0.3f);
    return pose;
}

Pose stand_cheer_at(float phase)
{
    const float share = hold(phase, 0.01f, 0.33f, 0.67f, 0.99f), within = loop(phase, 2);
    Pose pose = between_poses(stand_at(phase), cheer_at(within), share, cheer_heels_deg(within));
    for (const Side side : {Side::left, Side::right}) {
        const float left = side == Side::left ? 1.0f : -1.0f;
        blend_to_grip(pose, side, thrust(0.5f + 0.5f * left * wave(within, 2, -0.125f)), share, {0.02f, 0, 0.26f}, 2);
    }
    return pose;
}

}  // namespace claque::figures
