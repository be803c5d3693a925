#include "lib/math/affine.h"

#include <cmath>

namespace claque::math
{

Affine affine_of(const Trs &trs)
{
    const glm::mat3 r = glm::mat3_cast(trs.rotation);
    Affine a;
    a.set_column(0, r[0] * trs.scale.x);
    a.set_column(1, r[1] * trs.scale.y);
    a.set_column(2, r[2] * trs.scale.z);
    a.set_column(3, trs.translation);
    return a;
}

Affine affine_of(const glm::mat4 &m)
{
    Affine a;
    for (int k = 0; k < 4; ++k) a.set_column(k, glm::vec3(m[k]));
    return a;
}

glm::mat4 mat4_of(const Affine &a)
{
    return glm::mat4(glm::vec4(a.column(0), 0), glm::vec4(a.column(1), 0), glm::vec4(a.column(2), 0),
                     glm::vec4(a.column(3), 1));
}

glm::vec3 transform_vector(const Affine &a, glm::vec3 d)
{
    const float *c = a.c;
    return glm::vec3(c[0] * d.x + c[3] * d.y + c[6] * d.z, c[1] * d.x + c[4] * d.y + c[7] * d.z,
                     c[2] * d.x + c[5] * d.y + c[8] * d.z);
}

glm::vec3 transform_point(const Affine &a, glm::vec3 p) { return transform_vector(a, p) + a.column(3); }

Affine mul(const Affine &a, const Affine &b)
{
    Affine out;
    for (int k = 0; k < 3; ++k) out.set_column(k, transform_vector(a, b.column(k)));
    out.set_column(3, transform_point(a, b.column(3)));
    return out;
}

float determinant(const Affine &a) { return glm::dot(glm::cross(a.column(0), a.column(1)), a.column(2)); }

Affine inverse(const Affine &a)
{
    const float det = determinant(a);
    Affine out;
    if (det == 0) return out;
    // The rows of the inverse are the cross products of the columns divided by the determinant.
    const glm::vec3 r0 = glm::cross(a.column(1), a.column(2)) / det;
    const glm::vec3 r1 = glm::cross(a.column(2), a.column(0)) / det;
    const glm::vec3 r2 = glm::cross(a.column(0), a.column(1)) / det;
    out.set_column(0, glm::vec3(r0.x, r1.x, r2.x));
    out.set_column(1, glm::vec3(r0.y, r1.y, r2.y));
    out.set_column(2, glm::vec3(r0.z, r1.z, r2.z));
    out.set_column(3, glm::vec3(0));
    out.set_column(3, -transform_vector(out, a.column(3)));
    return out;
}

Affine normal_matrix(const Affine &a)
{
    const float det = determinant(a);
    glm::vec3 n[3] = {glm::cross(a.column(1), a.column(2)), glm::cross(a.column(2), a.column(0)),
                      glm::cross(a.column(0), a.column(1))};
    const float size = std::sqrt((glm::dot(n[0], n[0]) + glm::dot(n[1], n[1]) + glm::dot(n[2], n[2])) / 3.0f);
    const float factor = size > 0 ? (det < 0 ? -1.0f : 1.0f) / size : 0.0f;
    Affine out;
    for (int k = 0; k < 3; ++k) out.set_column(k, n[k] * factor);
    out.set_column(3, glm::vec3(0));
    return out;
}

bool is_similarity(const Affine &a, float tolerance)
{
    const glm::vec3 x = a.column(0), y = a.column(1), z = a.column(2);
    const float xx = glm::dot(x, x), yy = glm::dot(y, y), zz = glm::dot(z, z);
    const float limit = tolerance * xx;
    return std::fabs(yy - xx) <= 2 * limit && std::fabs(zz - xx) <= 2 * limit && std::fabs(glm::dot(x, y)) <= limit &&
           std::fabs(glm::dot(y, z)) <= limit && std::fabs(glm::dot(z, x)) <= limit;
}

}  // namespace claque::math
