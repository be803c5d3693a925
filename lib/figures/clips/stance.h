// Shared by all clips: feet that stand or roll on the ground, cloth that yields to the thighs, arms that hang.
#pragma once

#include "lib/figures/clips/pose.h"

namespace claque::figures
{

// A foot by its sole: its position when flat on the ground, and its roll from there.
struct Footing {
    float outwards = 0, ahead = 0;  // shift from the rest pose, flat on the ground
    float heel_up_deg = 0;          // raised about the ball; negative: toes raised about the heel
    float toes_flat = 1;            // 1: the toes stay level while the heel rises, 0: they follow the foot
    float lift = 0;                 // of the whole foot
    float yaw_deg = 0;              // toes outwards, beyond the rest pose
    float knee_out = 0.10f;         // how far the knee points outwards for each metre ahead
};

// Rotates thigh, shin, foot and toes so that the foot is there. The pelvis must be placed before.
void stand_on(Pose &pose, Side side, const Footing &footing);

// Makes the skirt follow the thighs, so that they do not penetrate it. To be called after the legs.
void drape(Pose &pose, float sway_deg = 0);

// An arm that hangs at the side. Degrees: forward and out from hanging, bend of the elbow.
void hang_arm(Pose &pose, Side side, float forward, float out, float elbow, float inwards = 0);

// 0: flat, 1: fist.
void curl_hand(Pose &pose, Side side, float curl);

// Places the wrist at a point; the elbow points along `pole`. Both are given for the left side and mirrored for the
// right.
void reach_hand(Pose &pose, Side side, glm::vec3 wrist, glm::vec3 pole);

}  // namespace claque::figures
