// A second evaluation of a clip, in double with the C library's functions, from the text of glTF 2.0: 4 x 4 matrices, a
// linear search; shares no code with lib/pose.
#pragma once

#include <vector>

#include "lib/model/rig.h"

namespace claque::reference
{

struct Mat4 {
    double m[16];  // column-major
};

Mat4 mul(const Mat4 &a, const Mat4 &b);
Mat4 mat_of(const math::Affine &a);

struct Node {
    std::vector<double> t, r, s;  // r: x y z w
};

// Relative to their parents, and the morph weights.
struct Locals {
    std::vector<Node> nodes;
    std::vector<double> weights;
};

struct Pose {
    std::vector<Mat4> palette;
    std::vector<double> weights;
};

Locals locals_at(const model::Rig &rig, uint32_t clip, double time_s);
Pose pose_of(const model::Rig &rig, const Locals &locals);
Pose evaluate(const model::Rig &rig, uint32_t clip, double time_s);

}  // namespace claque::reference
