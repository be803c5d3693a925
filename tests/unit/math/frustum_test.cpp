// The view frustum, compared with GL's clipping.
#include "lib/math/frustum.h"

#include <cmath>
#include <random>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace claque::math
{

namespace
{

Frustum of(const glm::mat4 &m) { return frustum_of(&m[0][0]); }

// Whether GL would keep the point.
bool in_clip_space(const glm::mat4 &m, const glm::dvec3 &p)
{
    const glm::dvec4 c = glm::dmat4(m) * glm::dvec4(p, 1);
    return std::fabs(c.x) <= c.w && std::fabs(c.y) <= c.w && std::fabs(c.z) <= c.w;
}

void points_agree(const glm::mat4 &m)
{
    const Frustum frustum = of(m);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(-30, 30), z(-120, 10);
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 p(x(random), x(random), z(random));
        EXPECT_EQ(test(frustum, p, 1e-9) != Containment::outside, in_clip_space(m, p));
        inside += in_clip_space(m, p);
    }
    EXPECT_GT(inside, 100);
}

}  // namespace

TEST(Frustum, KeepsThePointsThatGlKeepsInAPerspective) { points_agree(glm::perspective(0.9f, 1.3f, 0.5f, 100.0f)); }
TEST(Frustum, KeepsThePointsThatGlKeepsInAParallelProjection)
{
    points_agree(glm::ortho(-10.0f, 12.0f, -5.0f, 8.0f, 1.0f, 90.0f));
}

TEST(Frustum, ASphereIsVisibleAsSoonAsItReachesIn)
{
    const Frustum frustum = of(glm::perspective(1.5707963f, 1.0f, 1.0f, 100.0f));  // planes at 45 degrees
    const glm::dvec3 outside(-15, 0, -10);  // 5 / sqrt(2) = 3.536 outside the left plane
    EXPECT_EQ(test(frustum, outside, 3.53), Containment::outside);
    EXPECT_EQ(test(frustum, outside, 3.54), Containment::intersects);
    EXPECT_EQ(test(frustum, glm::dvec3(0, 0, -50), 5), Containment::inside);
    EXPECT_EQ(test(frustum, glm::dvec3(0, 0, -50), 35.35), Containment::inside) << "35.355 from four planes";
    EXPECT_EQ(test(frustum, glm::dvec3(0, 0, -50), 35.36), Containment::intersects);
    EXPECT_EQ(test(frustum, glm::dvec3(0, 0, 5), 5.9), Containment::outside);
    EXPECT_EQ(test(frustum, glm::dvec3(0, 0, -104), 5), Containment::intersects);
}

TEST(Frustum, AnInfiniteFarPlaneCutsNothing)
{
    glm::mat4 m = glm::perspective(1.0f, 1.0f, 1.0f, 100.0f);
    m[2][2] = -1;
    m[3][2] = -2;
    EXPECT_NE(test(of(m), glm::dvec3(0, 0, -1e9), 1), Containment::outside);
}

}  // namespace claque::math
