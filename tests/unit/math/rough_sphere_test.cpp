// What the coarse test leaves out, the test in double precision leaves out too, wherever in the world it is.
#include "lib/math/rough_sphere.h"

#include <cmath>
#include <random>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace claque::math
{

namespace
{

class RoughSphereTest : public ::testing::Test
{
protected:
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    glm::dvec3 anywhere(double size)
    {
        return glm::dvec3(between(-size, size), between(-size, size), between(-size, size));
    }
    // A frustum that looks anywhere.
    Frustum frustum(float far = 900)
    {
        const glm::mat4 projection = glm::perspective(float(between(0.2, 2)), float(between(0.5, 2)), 0.5f, far);
        const glm::dmat4 turn = glm::rotate(glm::dmat4(1), between(0, 6), anywhere(1));
        return rotated_back(frustum_of(&projection[0][0]), glm::dmat3(turn));
    }

    std::mt19937 random_{11};
};

}  // namespace

TEST_F(RoughSphereTest, LeavesOutNothingThatTheTestInDoublePrecisionKeeps)
{
    uint32_t near_misses = 0;
    for (uint32_t round = 0; round < 2000; ++round) {
        const bool is_eye_far = round % 2 == 0;  // of the sphere; or both are far away, near each other
        const Frustum exact = frustum(is_eye_far ? 1e12f : 900.0f);
        const double size = std::pow(10.0, between(-2, 9));
        const glm::dvec3 sweep = round % 3 == 0 ? anywhere(20) : glm::dvec3(0);
        for (uint32_t i = 0; i < 50; ++i) {
            // From a place in view out through a plane, to where the sphere only just touches the frustum.
            const Plane &plane = exact.planes[i % uint32_t(exact.count)];
            const double radius = std::pow(10.0, between(-3, 3)), touch = std::pow(10.0, between(-9, -2));
            glm::dvec3 away = anywhere(is_eye_far ? size : 500);
            away -= plane.normal * (glm::dot(plane.normal, away) + plane.offset + radius - radius * touch);
            glm::dvec3 centre = anywhere(is_eye_far ? 0.01 : size), eye = centre - away;
            if (is_eye_far && round / 2 % 2 == 0) eye = centre, centre = eye + away;
            const RoughFrustum rough(exact, eye, sweep);
            const bool kept = test_swept(exact, centre - eye, radius, sweep) != Containment::outside;
            near_misses += kept;
            ASSERT_FALSE(kept && is_outside(rough, rough_sphere_of(centre, radius)))
                << "round " << round << ", sphere " << i << " at " << size;
        }
    }
    EXPECT_GT(near_misses, 10000u);
}

TEST_F(RoughSphereTest, LeavesOutWhatIsACentimetreBesideTheFrustumHundredsOfMetresFromTheOrigin)
{
    for (uint32_t round = 0; round < 500; ++round) {
        const Frustum exact = frustum();
        const glm::dvec3 eye = anywhere(300);
        const RoughFrustum rough(exact, eye, glm::dvec3(0));
        for (const Plane &plane : exact.planes) {
            glm::dvec3 away = anywhere(300);
            away -= plane.normal * (glm::dot(plane.normal, away) + plane.offset + 1 + 0.01);
            EXPECT_TRUE(is_outside(rough, rough_sphere_of(eye + away, 1)));
        }
    }
}

TEST_F(RoughSphereTest, KeepsWhatSinglePrecisionCannotHold)
{
    const double huge[] = {2e37, 1e38, 4e38, 1e60, 1e300, HUGE_VAL, std::nan("")};
    for (const double far : huge)
        for (uint32_t i = 0; i < 50; ++i) {
            const Frustum exact = frustum();
            const RoughFrustum rough(exact, glm::dvec3(0), glm::dvec3(0)),
                beyond(exact, glm::dvec3(far, 0, 0), glm::dvec3(0));
            EXPECT_FALSE(is_outside(rough, rough_sphere_of(glm::dvec3(far, -far, 0), 1)));
            EXPECT_FALSE(is_outside(rough, rough_sphere_of(glm::dvec3(0, 0, 1), far)));
            EXPECT_FALSE(is_outside(beyond, rough_sphere_of(glm::dvec3(0), 1)));
            EXPECT_FALSE(is_outside(rough, RoughSphere()));
        }
}

}  // namespace claque::math
