// What "the same shape" means: every vertex within a tenth of a thousandth of the character's size.
#pragma once

#include <string>
#include <vector>

#include "tests/reference/gltf_reference.h"

namespace claque::reference
{

constexpr double tolerance = 1e-4;  // of the size

// Width, height and depth of the box round points; at least one point.
Vec3 extent_of(const std::vector<Vec3> &positions);

// Diagonal of the box round the rest pose; 1 where that has no extent (a single point, or no vertices).
double size_of(const Character &character);

struct Comparison {
    bool same = false;
    double worst = 0;  // largest distance over the size; infinite where counts differ or a number is not finite
    size_t vertex = 0;
    std::string text;  // one line that says where and how much
};

// `actual` is x, y, z of each vertex in a row.
Comparison compare(const std::vector<Vec3> &expected, const std::vector<float> &actual, double size);

}  // namespace claque::reference
