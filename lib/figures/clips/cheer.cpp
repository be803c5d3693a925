// Both arms up, the fists thrust at the sky in turn, heels off the ground with every thrust.
#include <cmath>

#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/stance.h"

namespace claque::figures
{

namespace
{

float beat_at(float phase) { return 0.5f + 0.5f * wave(phase, 4, -0.25f); }  // 1: up on the toes

}  // namespace

float cheer_heels_deg(float phase)
{
    const float beat = beat_at(phase);
    return 13 * beat * beat;
}

Pose cheer_at(float phase)
{
    Pose pose;
    const float beat = beat_at(phase);
    const float sway = wave(phase, 2, -0.125f);  // 1: the left fist is up
    const float heels = cheer_heels_deg(phase);
    pose.shift_pelvis({0.008f * sway, -0.034f + 0.048f * beat, 0.010f});
    pose.set(Bone::pelvis, roll(1.5f * sway) * pitch(1.0f));
    pose.set(Bone::spine, roll(-1.2f * sway) * pitch(-2.0f));
    pose.set(Bone::spine_upper, roll(1.5f * sway) * pitch(-2.5f));
    pose.set(Bone::chest, roll(3.0f * sway) * pitch(-3.0f) * yaw(-4 * sway));
    pose.set(Bone::neck, pitch(-4) * roll(-2 * sway));
    pose.set(Bone::head, pitch(-5 - 2 * beat) * roll(-2.0f * sway) * yaw(7 * wave(phase, 1, 0.1f)));
    for (const Side side : {Side::left, Side::right}) {
        const float left = side == Side::left ? 1.0f : -1.0f;
        const float up = 0.5f + 0.5f * left * sway;
        pose.set(side, Bone::clavicle, roll(12 + 10 * up));
        const glm::vec3 low(0.345f, 1.665f, 0.135f), high(0.265f, 1.930f, 0.070f);
        reach_hand(pose, side, low + (high - low) * up + glm::vec3(0, 0.03f * beat, 0),
                   glm::vec3(0.9f, -0.35f, -0.25f));
        curl_hand(pose, side, 1);
        stand_on(pose, side, {0.022f, 0, heels, 1, 0, 5});
    }
    drape(pose);
    return pose;
}

}  // namespace claque::figures
