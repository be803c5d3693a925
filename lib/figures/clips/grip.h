// Where a hand is and how it is held, always told for the left one.
#pragma once

#include "lib/figures/clips/pose.h"

namespace claque::figures
{

struct Grip {
    glm::vec3 wrist;
    glm::vec3 along;  // from the wrist to the fingers
    glm::vec3 back;   // out of the back of the hand
    glm::vec3 pole;   // where the elbow points
    float curl = 0;   // 0: flat, 1: fist
};

// On the way from one to another; in the middle the wrist is `arc` metres off the straight line, and the elbow hangs the
// more the greater `tuck` is, where it would point far out to the side.
Grip mix(const Grip &from, const Grip &to, float share, glm::vec3 arc = glm::vec3(0), float tuck = 0);

// A hand before the chest that claps with its mirror image; they meet in `middle` where `apart` is 0, fingers up and
// ahead, and open like a book up to 1.
Grip clapping(float apart, glm::vec3 middle);

// How a hand of a pose is held now; a little curled.
Grip grip_of(const Pose &pose, Side side);

// Takes an arm from where it is in the pose towards a grip: `share` 0 leaves it as it is, to the bit.
void blend_to_grip(Pose &pose, Side side, const Grip &to, float share, glm::vec3 arc, float tuck);

// Turns the bones of an arm towards those of another pose, all the way with `share` 1.
void blend_arm(Pose &pose, const Pose &as, Side side, float share);

// Reaches with arm, hand and fingers. The forearm takes half of the hand's turn about it, as its two bones do.
void apply_grip(Pose &pose, Side side, const Grip &grip);

}  // namespace claque::figures
