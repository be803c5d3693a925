// The pyramid that leaves out scenery: a sphere that reaches into the picture is kept, and one beyond an edge is not.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "samples/scenes/frustum.h"

namespace
{

using namespace scenes;

constexpr double aspect = 4.0 / 3, fov_y_deg = 50, near_m = 0.5, far_m = 900;

// A point by its place in the eye's own axes.
Vec3 in_world(const Eye &eye, double right, double up, double ahead)
{
    double at[3];
    for (size_t k = 0; k < 3; ++k)
        at[k] = eye.position[k] + right * static_cast<double>(eye.view[4 * k]) +
                up * static_cast<double>(eye.view[4 * k + 1]) - ahead * static_cast<double>(eye.view[4 * k + 2]);
    return {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])};
}

class SceneryFrustum : public ::testing::Test
{
protected:
    double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    Eye any_eye()
    {
        const double eye[3] = {in(-50, 50), in(1, 60), in(-50, 50)};
        const double target[3] = {eye[0] + in(1, 20), in(0, 20), eye[2] + in(1, 20)};
        return eye_of(look(eye, target, fov_y_deg, aspect, near_m, far_m));
    }
    // So far out from a point of one of the four sides, at right angles to it.
    Vec3 beyond_an_edge(const Eye &eye, int side, double far_out)
    {
        const double ahead = in(40, 200), sign = side % 2 == 0 ? 1 : -1;
        const bool is_level = side % 4 < 2;
        const double slope = is_level ? wide_ : high_, length = std::sqrt(1 + slope * slope);
        const double out = sign * (slope * ahead + far_out / length), back = ahead - far_out * slope / length;
        return is_level ? in_world(eye, out, 0, back) : in_world(eye, 0, out, back);
    }
    const double high_ = std::tan(fov_y_deg / 2 * 3.14159265358979 / 180), wide_ = aspect * high_;  // at 1 m

private:
    std::mt19937 random_;
};

TEST_F(SceneryFrustum, MeetsEachSphereThatReachesIntoThePicture)
{
    for (int i = 0; i < 5000; ++i) {
        const Eye eye = any_eye();
        const double ahead = in(1, 200), radius = in(0.1, 40);
        const double right = in(-1, 1) * 0.99 * wide_ * ahead, up = in(-1, 1) * 0.99 * high_ * ahead;
        const double turn = in(0, 6.3), rise = in(-1, 1), level = std::sqrt(1 - rise * rise);
        const Vec3 centre = in_world(eye, right + 0.99 * radius * level * std::cos(turn), up + 0.99 * radius * rise,
                                     ahead + 0.99 * radius * level * std::sin(turn));
        ASSERT_TRUE(Frustum(eye).meets({centre, static_cast<float>(radius)})) << i;
    }
}

TEST_F(SceneryFrustum, MeetsEachSphereThatReachesOverAnEdge)
{
    for (int i = 0; i < 5000; ++i) {
        const double radius = in(0.1, 10);
        const Eye eye = any_eye();
        ASSERT_TRUE(Frustum(eye).meets({beyond_an_edge(eye, i, 0.99 * radius), static_cast<float>(radius)})) << i;
    }
}

TEST_F(SceneryFrustum, LeavesOutEachSphereBeyondAnEdge)
{
    for (int i = 0; i < 5000; ++i) {
        const double radius = in(0.1, 40);
        const Eye eye = any_eye();
        ASSERT_FALSE(Frustum(eye).meets({beyond_an_edge(eye, i, 1.01 * radius), static_cast<float>(radius)})) << i;
    }
}

}  // namespace
