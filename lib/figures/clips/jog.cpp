// One cycle of a jog, two steps on the spot as on a treadmill. While a foot carries, it moves back at a constant speed;
// between the steps both feet are off the ground. The left foot lands at phase 0, the right one at 0.5, as in the walk.

#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/stance.h"
#include "lib/math/trig.h"

namespace claque::figures
{

namespace
{

constexpr float jog_stride_m = 1.76f;   // per cycle: 2.4 m/s with 22 frames
constexpr float jog_carry_end = 0.36f;  // fraction of the cycle at which the toes leave the ground
constexpr float jog_ahead_m = 0.23f;    // of the foot when it lands
constexpr float jog_strike_deg = -6, jog_leave_deg = 54;

Footing jog_footing(float phase)
{
    Footing f;
    f.yaw_deg = 1;
    f.outwards = -0.045f;  // nearer to the middle than in the walk
    f.knee_out = 0.06f;
    if (phase < jog_carry_end) {
        f.ahead = jog_ahead_m - jog_stride_m * phase;
        f.heel_up_deg = phase < 0.12f
                            ? jog_strike_deg * (1 - smooth(-0.05f, 0.11f, phase)) / (1 - smooth(-0.05f, 0.11f, 0))
                            : jog_leave_deg * smooth(0.14f, 0.40f, phase) / smooth(0.14f, 0.40f, jog_carry_end);
        return f;
    }
    const float t = (phase - jog_carry_end) / (1 - jog_carry_end), length = 1 - jog_carry_end;
    f.ahead = hermite(jog_ahead_m - jog_stride_m * jog_carry_end, -jog_stride_m * length, jog_ahead_m,
                      -jog_stride_m * length, t);
    f.heel_up_deg = hermite(jog_leave_deg, 112, jog_strike_deg, 40, t);
    f.toes_flat = 1 - smooth(0, 0.6f, t);
    // The tips of the toes are below the ball while the foot is steep. The foot swings through below the body.
    const float toes_deg = f.heel_up_deg > 0 ? f.heel_up_deg * (1 - f.toes_flat) : 0;
    const float rise = math::sin(pi * t);
    f.lift = 0.085f * math::sin(toes_deg * pi / 180) + 0.10f * rise * rise;
    return f;
}

}  // namespace

Pose jog_at(float phase)
{
    Pose pose;
    const float lead = math::cos(2 * pi * phase);               // 1: the left foot comes down
    const float carried = math::sin(2 * pi * (phase + 0.07f));  // 1: the left leg carries
    // Lowest in the middle of the carrying phase, highest in flight.
    pose.shift_pelvis({0.012f * carried, -0.048f - 0.032f * math::cos(4 * pi * (phase - 0.17f)), 0.01f});
    pose.set(Bone::pelvis, yaw(-8 * lead) * roll(2.2f * carried) * pitch(7.0f));
    pose.set(Bone::spine, yaw(5.0f * lead) * roll(-1.4f * carried) * pitch(1.0f));
    pose.set(Bone::spine_upper, yaw(5.5f * lead) * roll(-1.0f * carried) * pitch(1.0f));
    pose.set(Bone::chest, yaw(5.5f * lead) * pitch(0.5f));
    pose.set(Bone::neck, yaw(-4.0f * lead) * pitch(-3.0f));
    pose.set(Bone::head, yaw(-3.5f * lead) * pitch(-5.0f + 1.2f * math::cos(4 * pi * phase)));
    for (const Side side : {Side::left, Side::right}) {
        const float own = side == Side::left ? phase : phase < 0.5f ? phase + 0.5f : phase - 0.5f;
        const float swing = -math::cos(2 * pi * (own + 0.02f));  // 1: this arm is in front
        hang_arm(pose, side, -8 + 30 * swing, 20, 84 + 12 * swing, 12);
        curl_hand(pose, side, 0.55f);
        stand_on(pose, side, jog_footing(own));
    }
    drape(pose);
    return pose;
}

}  // namespace claque::figures
