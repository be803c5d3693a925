// Transforms to eye space, exact far from the world's origin too.
#include "lib/math/eye_transform.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lib/math/affine.h"
#include "lib/math/slerp.h"

namespace claque::math
{

TEST(EyeTransform, IsTheUsualProductOfMatrices)
{
    const glm::quat turn = unit_quat(0.3, 0.5, -0.2, 0.7), look = unit_quat(0.9, 0.1, 0.3, -0.2);
    float m[16];
    store_matrix(eye_transform(rotation_of(look), glm::dvec3(1, 2, 3), glm::dvec3(4, -5, 6), turn, 1.5), m);
    const glm::vec3 p(0.3f, -0.7f, 0.2f);
    const glm::vec3 world = turn * (p * 1.5f) + glm::vec3(4, -5, 6);
    const glm::vec3 expected = look * (world - glm::vec3(1, 2, 3));
    for (int r = 0; r < 3; ++r) {
        EXPECT_NEAR(m[r] * p.x + m[4 + r] * p.y + m[8 + r] * p.z + m[12 + r], expected[r], 2e-6);
        EXPECT_EQ(m[4 * r + 3], 0);
    }
    EXPECT_EQ(m[15], 1);
}

TEST(EyeTransform, AWorldOfAMillionMetresDoesNotShake)
{
    const glm::dvec3 far(1e6, -1e6, 1e6);
    const glm::dmat3 look = rotation_of(unit_quat(0.9, 0.1, 0.3, -0.2));
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 step(0.001 * i, 0, -0.0005 * i);
        float near_origin[16], far_away[16];
        store_matrix(eye_transform(look, glm::dvec3(0), glm::dvec3(3, 0, -7) + step, glm::quat(1, 0, 0, 0), 1),
                     near_origin);
        store_matrix(eye_transform(look, far, far + glm::dvec3(3, 0, -7) + step, glm::quat(1, 0, 0, 0), 1), far_away);
        for (int k = 0; k < 16; ++k) EXPECT_NEAR(near_origin[k], far_away[k], 1e-6) << i;  // a micrometre
    }
}

}  // namespace claque::math
