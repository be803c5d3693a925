// Standing: breath, weight from one leg to the other and back, a look to either side.
#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/stance.h"

namespace claque::figures
{

Pose stand_at(float phase)
{
    Pose pose;
    const float breath = wave(phase, 2, 0.1f);
    const float weight = wave(phase, 1);  // on the left leg where positive
    pose.shift_pelvis(
        {0.022f * weight, -0.005f - 0.003f * weight * weight + 0.001f * breath, 0.004f * wave(phase, 1, 0.3f)});
    pose.set(Bone::pelvis, roll(2.2f * weight) * yaw(2.0f * wave(phase, 1, 0.1f)));
    pose.set(Bone::spine, roll(-1.4f * weight) * pitch(1.0f));
    pose.set(Bone::spine_upper, roll(-1.2f * weight) * pitch(-0.6f - 0.5f * breath));
    pose.set(Bone::chest, pitch(-0.6f - 0.9f * breath) * yaw(2.0f * wave(phase, 1, 0.85f)));
    const float look = 15 * wave(phase, 1, 0.80f) + 6 * wave(phase, 2, 0.15f);
    pose.set(Bone::neck, yaw(0.4f * look) * pitch(1.5f + 0.5f * breath));
    pose.set(Bone::head,
             yaw(0.6f * look) * pitch(-1.0f + 2.0f * wave(phase, 1, 0.55f)) * roll(1.5f * wave(phase, 1, 0.4f)));
    for (const Side side : {Side::left, Side::right}) {
        const float s = side == Side::left ? 1.0f : -1.0f;
        pose.set(side, Bone::clavicle, roll(1.0f + 1.1f * breath));
        hang_arm(pose, side, 1.5f + 1.2f * s * wave(phase, 1, 0.2f), 9 + 0.8f * breath + 1.0f * s * weight,
                 15 + 3 * wave(phase, 1, side == Side::left ? 0.3f : 0.65f), 12);
        curl_hand(pose, side, 0.16f + 0.03f * wave(phase, 1, 0.5f));
        stand_on(pose, side, {0.012f, side == Side::left ? 0.016f : -0.010f, 0, 1, 0, 5});
    }
    drape(pose, -1.2f * weight);
    return pose;
}

}  // namespace claque::figures
