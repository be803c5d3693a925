// The position and orientation of a hand, always given for the left one.
#pragma once

#include "lib/figures/clips/pose.h"

namespace claque::figures
{

struct Grip {
    glm::vec3 wrist;
    glm::vec3 along;  // from the wrist to the fingers
    glm::vec3 back;   // out of the back of the hand
    glm::vec3 pole;   // direction of the elbow
    float curl = 0;   // 0: flat, 1: fist
};

// Interpolates two grips. Halfway the wrist is `arc` metres off the straight line. A greater `tuck` lowers an elbow
// that would point far to the side.
Grip mix(const Grip &from, const Grip &to, float share, glm::vec3 arc = glm::vec3(0), float tuck = 0);

// A hand that claps in front of the chest with its mirror image. They meet at `middle` when `apart` is 0, fingers
// pointing up and ahead, and open like a book up to 1.
Grip clapping(float apart, glm::vec3 middle);

// The present grip of a hand in a pose, slightly curled.
Grip grip_of(const Pose &pose, Side side);

// Moves an arm from its pose towards a grip; `share` 0 leaves it unchanged to the bit.
void blend_to_grip(Pose &pose, Side side, const Grip &to, float share, glm::vec3 arc, float tuck);

// Moves a wrist to a point, both it and the direction of the elbow as they are on that side. Bones keep their twist
// about themselves, and the hand keeps its direction.
void move_wrist(Pose &pose, Side side, glm::vec3 wrist, glm::vec3 pole);

// Rotates the bones of an arm towards those of another pose, fully with `share` 1.
void blend_arm(Pose &pose, const Pose &as, Side side, float share);

// Sets arm, hand and fingers. The forearm takes half of the hand's twist, as its two bones do.
void apply_grip(Pose &pose, Side side, const Grip &grip);

}  // namespace claque::figures
