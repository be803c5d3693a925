// Standing and clapping in front of the chest, six claps a loop.

#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/grip.h"
#include "lib/figures/clips/stance.h"
#include "lib/math/trig.h"

namespace claque::figures
{

namespace
{

constexpr int claps = 6;

void clap(Pose &pose, Side side, const Grip &grip)
{
    reach_hand(pose, side, grip.wrist, grip.pole);
    glm::quat hand = rotation_between_frames(arm_direction(), arm_dorsal(), grip.along, grip.back);
    pose.set_world(on(side, Bone::hand), side == Side::left ? hand : mirrored(hand));
    curl_hand(pose, side, grip.curl);
}

}  // namespace

Pose applaud_at(float phase)
{
    Pose pose;
    const float s = math::sin(pi * claps * phase);
    const float apart = s * s;  // 0: the palms meet
    const float sway = wave(phase, 1), nod = wave(phase, 2, 0.2f);
    pose.shift_pelvis({0.012f * sway, -0.014f - 0.002f * (1 - apart), 0});
    pose.set(Bone::pelvis, roll(1.2f * sway) * yaw(2.5f * wave(phase, 1, 0.2f)));
    pose.set(Bone::spine, pitch(1.5f) * roll(-0.8f * sway));
    pose.set(Bone::spine_upper, pitch(1.0f + 0.5f * (1 - apart)));
    pose.set(Bone::chest, pitch(0.5f * nod) * yaw(1.5f * wave(phase, 1, 0.4f)));
    pose.set(Bone::neck, pitch(-1.5f) * yaw(4 * wave(phase, 1, 0.3f)));
    pose.set(Bone::head, pitch(-2 + 2.5f * nod) * yaw(5 * wave(phase, 1, 0.3f)) * roll(1.5f * sway));
    for (const Side side : {Side::left, Side::right}) {
        const float left = side == Side::left ? 1.0f : -1.0f;
        pose.set(side, Bone::clavicle, roll(3) * yaw(-8 + 3 * apart));
        clap(pose, side, clapping(apart, glm::vec3(0, 1.245f + 0.006f * sway, 0.345f)));
        stand_on(pose, side, {0.016f, left * 0.010f, 0, 1, 0, 6});
    }
    drape(pose);
    return pose;
}

}  // namespace claque::figures
