// 3x4 matrices by column: x axis, y axis, z axis, translation. At 48 bytes palettes stay small, and a 4-lane load of a
// column needs no shuffle; lane 3 holds the next column's first number and is ignored. An array that such loads read
// needs one more float after its end.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace claque::math
{

struct Affine {
    float c[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

    glm::vec3 column(int k) const { return glm::vec3(c[3 * k], c[3 * k + 1], c[3 * k + 2]); }
    void set_column(int k, glm::vec3 v) { c[3 * k] = v.x, c[3 * k + 1] = v.y, c[3 * k + 2] = v.z; }
};

// Scale, then rotation, then translation: the local transform of a glTF node or key-pose.
struct Trs {
    glm::vec3 translation = glm::vec3(0);
    glm::quat rotation = glm::quat(1, 0, 0, 0);  // (w, x, y, z)
    glm::vec3 scale = glm::vec3(1);
};

Affine affine_of(const Trs &trs);
Affine affine_of(const glm::mat4 &matrix);
glm::mat4 mat4_of(const Affine &a);
Affine mul(const Affine &a, const Affine &b);  // applies b first
Affine inverse(const Affine &a);               // the identity for a singular matrix; check determinant() first
float determinant(const Affine &a);
glm::vec3 transform_point(const Affine &a, glm::vec3 p);
glm::vec3 transform_vector(const Affine &a, glm::vec3 d);

// Transforms the directions of normals: the inverse transpose of the upper 3x3 without translation, scaled to the size
// of a rotation. If `a` is a similarity, mirrored or not, it is `a` up to that factor.
Affine normal_matrix(const Affine &a);

// True if the upper 3x3 is a rotation times one factor, possibly mirrored, within `tolerance` of the factor.
bool is_similarity(const Affine &a, float tolerance = 1e-4f);

}  // namespace claque::math
