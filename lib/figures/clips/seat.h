// What every seated clip shares: a body whose hips stay on the seat and whose feet stay where they stand in `stand`,
// cloth over the lap, and hands that lie there unless they have something to do.
#pragma once

#include "lib/figures/clips/grip.h"

namespace claque::figures
{

// How body and head are held; as it is made, it is the neutral sitting pose. Degrees.
struct Posture {
    float tilt = -13;  // of the pelvis, forwards where positive
    float bend = 21;   // of the spine over the pelvis, forwards
    float twist = 0;   // of the chest over the pelvis, to the left
    float sway = 0;    // of the chest over the pelvis, to the right
    float breath = 0;  // -1 to 1
    float nod = 2;     // of the face from the level, downwards
    float look = 0;    // of the face over the chest, to the left
    float cock = 0;    // of the head, to the right
    float shrug_l = 0, shrug_r = 0;
    glm::vec3 hips = glm::vec3(0);  // off their place on the seat, metres
    float knees_out = 0.03f;        // as of Footing
};

// Pelvis to head, collar bones, both legs and the cloth over them; not the arms.
Pose posed(const Posture &posture);

// A hand that lies on its thigh; each side has its own, as people do.
Grip in_lap(Side side);

// Body and both hands.
Pose seated(const Posture &posture, const Grip &left, const Grip &right);

// Cloth that goes with the thighs as far as these are raised, and hangs as of drape() where they are not.
void drape_lap(Pose &pose);

}  // namespace claque::figures
