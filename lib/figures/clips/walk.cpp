// One cycle of a walk, two steps on the spot as on a treadmill. While a foot carries, it moves back at a constant
// speed.

#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/stance.h"
#include "lib/math/trig.h"

namespace claque::figures
{

namespace
{

constexpr float stride_m = 1.24f;   // per cycle: 1.13 m/s with 33 frames
constexpr float carry_end = 0.62f;  // fraction of the cycle at which the toes leave the ground
constexpr float ahead_m = 0.335f;   // of the foot when the heel strikes

constexpr float strike_deg = -17, leave_deg = 52;

Footing footing(float phase)
{
    Footing f;
    f.yaw_deg = 2;
    f.outwards = -0.028f;
    if (phase < carry_end) {
        f.ahead = ahead_m - stride_m * phase;
        f.heel_up_deg = phase < 0.30f ? strike_deg * (1 - smooth(-0.05f, 0.11f, phase)) / (1 - smooth(-0.05f, 0.11f, 0))
                                      : leave_deg * smooth(0.33f, 0.72f, phase) / smooth(0.33f, 0.72f, carry_end);
        return f;
    }
    const float t = (phase - carry_end) / (1 - carry_end), length = 1 - carry_end;
    f.ahead = hermite(ahead_m - stride_m * carry_end, -stride_m * length, ahead_m, -stride_m * length, t);
    f.heel_up_deg = hermite(leave_deg, 66, strike_deg, 50, t);
    f.toes_flat = 1 - smooth(0, 0.55f, t);
    // High enough for the tips of the toes, which point down while the foot is steep.
    const float toes_deg = f.heel_up_deg > 0 ? f.heel_up_deg * (1 - f.toes_flat) : 0;
    f.lift = 0.085f * math::sin(toes_deg * pi / 180) + 0.024f * math::sin(pi * t);
    return f;
}

}  // namespace

Pose walk_at(float phase)
{
    Pose pose;
    const float lead = math::cos(2 * pi * phase);               // 1: the left heel strikes
    const float carried = math::sin(2 * pi * (phase - 0.05f));  // 1: the left leg carries
    pose.shift_pelvis({0.020f * carried, -0.030f - 0.016f * math::cos(4 * pi * (phase - 0.05f)), 0});
    pose.set(Bone::pelvis, yaw(-7 * lead) * roll(2.6f * carried) * pitch(3.0f));
    pose.set(Bone::spine, yaw(4.0f * lead) * roll(-1.6f * carried) * pitch(0.5f));
    pose.set(Bone::spine_upper, yaw(4.5f * lead) * roll(-1.2f * carried));
    pose.set(Bone::chest, yaw(4.0f * lead) * pitch(-0.5f));
    pose.set(Bone::neck, yaw(-3.0f * lead) * pitch(-1.0f));
    pose.set(Bone::head, yaw(-2.5f * lead) * pitch(-1.5f + 0.8f * math::cos(4 * pi * phase)));
    for (const Side side : {Side::left, Side::right}) {
        const float own = side == Side::left ? phase : phase < 0.5f ? phase + 0.5f : phase - 0.5f;
        const float swing = -math::cos(2 * pi * (own + 0.02f));  // 1: this arm is in front
        hang_arm(pose, side, 1 + 20 * swing, 10.5f, 19 + 9 * swing, 10);
        curl_hand(pose, side, 0.22f);
        stand_on(pose, side, footing(own));
    }
    drape(pose);
    return pose;
}

}  // namespace claque::figures
