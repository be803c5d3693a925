// The skeleton of the dragon of `hundred_actors` (S0 6.1, Table 3): 40 Skeleton nodes with 80 degrees of freedom. 20
// nodes remain from one distance on and 10 from another (S0 5.2).
#pragma once

#include <claque/template.h>

#include <array>

namespace scenes::hundred
{

constexpr float mid_m = 52, far_m = 100;  // effective distances at which nodes end and merged parts begin

struct Bone {
    const char *name;
    int parent;      // -1: none
    double x, y, z;  // of its joint at rest, in model space: metres, +z ahead, +y up
    float ends_m;    // 0: never
};

constexpr size_t bone_count = 40, dof_count = 80;
using Skeleton = std::array<Bone, bone_count>;

// Parents first. Pieces are built in these coordinates.
const Skeleton &skeleton();

enum Joint : uint32_t {
    heart,
    chest,
    shoulder,
    neck1,
    neck2,
    neck3,
    head,
    jaw,
    eye_l,
    eye_r,
    whisker_l,
    whisker_r,
    crest,
    ear_l,
    ear_r,
    loin,
    hip,
    tail1,
    tail10 = tail1 + 9,
    fin,
    legs  // four times thigh, shank, foot: left and right in front, left and right behind
};

// Named node.what: yaw to the left, pitch upwards, roll to the right, thrust ahead.
std::array<clq_dof_def, dof_count> dofs();

}  // namespace scenes::hundred
