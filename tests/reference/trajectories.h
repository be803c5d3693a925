// Splitting reorders, repeats and drops vertices, so split vertices are known by where they go: a split vertex is held
// to be a file's vertex if it is with it in every one of several poses.
#pragma once

#include <string>
#include <vector>

#include "tests/reference/gltf_reference.h"

namespace claque::reference
{

struct Vertices {
    std::vector<Vec3> positions, normals;  // normals of any length
};

// One pose of one character, as the reference has it and as it was skinned after splitting.
struct Pose {
    Shape expected;
    Vertices actual;
};

struct Matching {
    bool same = false;
    size_t strays = 0;       // actual vertices that no vertex of the file goes with
    size_t missing = 0;      // vertices of the file that are used and that no actual one goes with
    size_t bad_normals = 0;  // actual vertices none of whose partners has the same normals
    std::string text;        // the counts, and the first of each
};

// The largest angle in radians between a true normal (by the inverse transpose of the blended matrix) and one that was
// turned by the blended matrix itself, plus `slack`, for a matrix of this condition number: the eigenvectors of a
// symmetric matrix of condition k * k turn no vector further than acos(2k / (1 + k * k)).
double normal_limit(double stretch, double slack);

constexpr double normal_slack = 1.0 / 57.29577951308232;  // one degree

// All poses have the same counts. `used` says which of the file's vertices must be found.
Matching match(const std::vector<Pose> &poses, const std::vector<bool> &used, double distance);

}  // namespace claque::reference
