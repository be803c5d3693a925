// Stepping on the spot, in step with the walk, for a body that turns meanwhile: one foot after the other is lifted and
// put down where it was. Where it comes down is the track's affair.

#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/stance.h"
#include "lib/math/trig.h"

namespace claque::figures
{

namespace
{

constexpr float turn_carry_end = 0.64f;  // fraction of the cycle at which the foot leaves the ground
constexpr float turn_leave_deg = 15;     // of the heel, when the toes leave the ground

Footing turn_footing(Side side, float phase)
{
    Footing f;
    f.yaw_deg = 5;
    f.outwards = 0.012f;
    f.ahead = side == Side::left ? 0.016f : -0.010f;  // as in stand
    if (phase < turn_carry_end) {
        f.heel_up_deg = turn_leave_deg * smooth(0.50f, 0.74f, phase) / smooth(0.50f, 0.74f, turn_carry_end);
        return f;
    }
    const float t = (phase - turn_carry_end) / (1 - turn_carry_end);
    f.heel_up_deg = hermite(turn_leave_deg, 26, 0, 0, t);
    f.toes_flat = 1 - smooth(0, 0.5f, t);
    const float toes_deg = f.heel_up_deg * (1 - f.toes_flat), rise = math::sin(pi * t);
    f.lift = 0.085f * math::sin(toes_deg * pi / 180) + 0.040f * rise * rise;
    return f;
}

}  // namespace

Pose turn_at(float phase)
{
    Pose pose;
    const float carried = math::sin(2 * pi * (phase - 0.07f));  // 1: the left leg carries
    pose.shift_pelvis({0.030f * carried, -0.012f - 0.005f * math::cos(4 * pi * (phase - 0.06f)), 0});
    pose.set(Bone::pelvis, roll(1.8f * carried) * pitch(1));
    pose.set(Bone::spine, roll(-1.2f * carried) * pitch(0.5f));
    pose.set(Bone::spine_upper, roll(-0.9f * carried));
    pose.set(Bone::chest, pitch(-0.6f));
    pose.set(Bone::neck, pitch(1));
    pose.set(Bone::head, pitch(-0.5f));
    for (const Side side : {Side::left, Side::right}) {
        const float own = side == Side::left ? phase : phase < 0.5f ? phase + 0.5f : phase - 0.5f;
        const float s = side == Side::left ? 1.0f : -1.0f;
        hang_arm(pose, side, 2 + 1.5f * wave(phase, 2, 0.1f), 12.5f + 0.8f * s * carried, 16, 12);
        curl_hand(pose, side, 0.18f);
        stand_on(pose, side, turn_footing(side, own));
    }
    drape(pose);
    return pose;
}

}  // namespace claque::figures
