// Shared by all seated clips: a body whose hips stay on the seat and whose feet stay as in `stand`, cloth over the lap,
// and hands that lie there unless a clip uses them.
#pragma once

#include "lib/figures/clips/grip.h"

namespace claque::figures
{

// The posture of body and head in degrees; the defaults are the neutral sitting pose.
struct Posture {
    float tilt = -13;  // of the pelvis, forwards if positive
    float bend = 21;   // of the spine over the pelvis, forwards
    float twist = 0;   // of the chest over the pelvis, to the left
    float sway = 0;    // of the chest over the pelvis, to the right
    float breath = 0;  // -1 to 1
    float nod = 2;     // of the face from level, downwards
    float look = 0;    // of the face relative to the chest, to the left
    float cock = 0;    // of the head, to the right
    float shrug_l = 0, shrug_r = 0;
    glm::vec3 hips = glm::vec3(0);  // offset from their position on the seat, metres
    float knees_out = 0.03f;        // as of Footing
};

// Pelvis to head, collar bones, both legs and the cloth over them, without the arms.
Pose posed(const Posture &posture);

// A hand that lies on its thigh; the two sides differ, as in real people.
Grip in_lap(Side side);

// Body and both hands.
Pose seated(const Posture &posture, const Grip &left, const Grip &right);

// Cloth follows the thighs as far as they are raised; otherwise it hangs as in drape().
void drape_lap(Pose &pose);

}  // namespace claque::figures
