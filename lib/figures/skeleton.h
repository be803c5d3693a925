// The skeleton of all built-in people: 33 nodes whose rest rotations are the identity, so that a clip's rotation is a
// rotation about the figure's own axes (X to its left, Y up, Z ahead).
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "lib/figures/charts.h"
#include "lib/model/rig.h"

namespace claque::figures
{

// Of a pair of bones the left one is named; the right one is next.
enum class Bone : uint8_t {
    root,
    pelvis,
    spine,
    spine_upper,
    chest,
    neck,
    head,
    clavicle,
    clavicle_r,
    upper_arm,
    upper_arm_r,
    forearm,
    forearm_r,
    hand,
    hand_r,
    thumb,
    thumb_r,
    fingers,
    fingers_r,
    fingertips,
    fingertips_r,
    thigh,
    thigh_r,
    shin,
    shin_r,
    foot,
    foot_r,
    toes,
    toes_r,
    skirt_front,
    skirt_front_r,
    skirt_back,
    skirt_back_r
};
constexpr int bone_count = 33;

constexpr int index_of(Bone bone) { return static_cast<int>(bone); }
constexpr Bone on(Side side, Bone left)
{
    return side == Side::left ? left : static_cast<Bone>(static_cast<int>(left) + 1);
}

struct Skeleton {
    std::array<int, bone_count> parents;       // -1 for the root
    std::array<glm::vec3, bone_count> joints;  // rest positions in model space
    std::array<const char *, bone_count> names;

    glm::vec3 joint(Bone bone) const { return joints[static_cast<size_t>(bone)]; }
    glm::vec3 offset(Bone bone) const;  // from the parent's joint
};

// For a figure 1.75 m tall.
const Skeleton &skeleton();

// The direction of the left upper arm and forearm in the rest pose, and those to the back of the hand and the thumb.
glm::vec3 arm_direction();
glm::vec3 arm_dorsal();
inline glm::vec3 arm_thumbward() { return glm::vec3(0, 0, 1); }

// Adds the nodes and matrix palette of the skeleton; add_clip adds clips.
void add_skeleton(model::Rig &rig);

}  // namespace claque::figures
