// One cycle of a slow walk on the spot, in step with the walk: short steps, both feet on the ground for a third of the
// time, and weight that goes farther to each side than in the walk.

#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/stance.h"
#include "lib/math/trig.h"

namespace claque::figures
{

namespace
{

constexpr float slow_stride_m = 0.68f;   // per cycle: 0.57 m/s with 36 frames
constexpr float slow_carry_end = 0.66f;  // fraction of the cycle at which the toes leave the ground
constexpr float slow_ahead_m = 0.190f;   // of the foot when the heel strikes
constexpr float slow_strike_deg = -9, slow_leave_deg = 34;

Footing slow_footing(float phase)
{
    Footing f;
    f.yaw_deg = 3;
    f.outwards = -0.012f;
    if (phase < slow_carry_end) {
        f.ahead = slow_ahead_m - slow_stride_m * phase;
        f.heel_up_deg = phase < 0.30f
                            ? slow_strike_deg * (1 - smooth(-0.05f, 0.13f, phase)) / (1 - smooth(-0.05f, 0.13f, 0))
                            : slow_leave_deg * smooth(0.40f, 0.76f, phase) / smooth(0.40f, 0.76f, slow_carry_end);
        return f;
    }
    const float t = (phase - slow_carry_end) / (1 - slow_carry_end), length = 1 - slow_carry_end;
    f.ahead = hermite(slow_ahead_m - slow_stride_m * slow_carry_end, -slow_stride_m * length, slow_ahead_m,
                      -slow_stride_m * length, t);
    f.heel_up_deg = hermite(slow_leave_deg, 44, slow_strike_deg, 26, t);
    f.toes_flat = 1 - smooth(0, 0.55f, t);
    // High enough for the tips of the toes, which point down while the foot is steep.
    const float toes_deg = f.heel_up_deg > 0 ? f.heel_up_deg * (1 - f.toes_flat) : 0;
    f.lift = 0.085f * math::sin(toes_deg * pi / 180) + 0.018f * math::sin(pi * t);
    return f;
}

}  // namespace

Pose walk_slow_at(float phase)
{
    Pose pose;
    const float lead = math::cos(2 * pi * phase);               // 1: the left heel strikes
    const float carried = math::sin(2 * pi * (phase - 0.07f));  // 1: the left leg carries
    pose.shift_pelvis({0.027f * carried, -0.014f - 0.006f * math::cos(4 * pi * (phase - 0.06f)), 0});
    pose.set(Bone::pelvis, yaw(-3.5f * lead) * roll(2.0f * carried) * pitch(1.5f));
    pose.set(Bone::spine, yaw(2.0f * lead) * roll(-1.3f * carried) * pitch(0.5f));
    pose.set(Bone::spine_upper, yaw(2.2f * lead) * roll(-1.0f * carried));
    pose.set(Bone::chest, yaw(2.0f * lead) * pitch(-0.6f));
    pose.set(Bone::neck, yaw(-1.4f * lead) * pitch(0.5f));
    pose.set(Bone::head, yaw(-1.3f * lead) * pitch(-0.5f + 0.4f * math::cos(4 * pi * phase)));
    for (const Side side : {Side::left, Side::right}) {
        const float own = side == Side::left ? phase : phase < 0.5f ? phase + 0.5f : phase - 0.5f;
        const float swing = -math::cos(2 * pi * (own + 0.02f));  // 1: this arm is in front
        hang_arm(pose, side, 1 + 9 * swing, 9.8f, 16 + 4 * swing, 11);
        curl_hand(pose, side, 0.19f);
        stand_on(pose, side, slow_footing(own));
    }
    drape(pose);
    return pose;
}

}  // namespace claque::figures
