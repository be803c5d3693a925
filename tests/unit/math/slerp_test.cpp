// Spherical interpolation, compared with the formula of glTF 2.0.
#include "lib/math/slerp.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace claque::math
{

namespace
{

// The formula of the glTF 2.0 specification, in double, with the C library's functions; the angle by atan2, which stays
// exact for small ones.
void reference(const glm::quat &a, const glm::quat &b, double t, double out[4])
{
    double p[4] = {a.w, a.x, a.y, a.z}, q[4] = {b.w, b.x, b.y, b.z};
    double pp = 0, qq = 0, d = 0, apart = 0, together = 0, square = 0;
    for (int i = 0; i < 4; ++i) pp += p[i] * p[i], qq += q[i] * q[i], d += p[i] * q[i];
    const double sign = d < 0 ? -1 : 1;
    for (int i = 0; i < 4; ++i) {
        p[i] /= std::sqrt(pp), q[i] *= sign / std::sqrt(qq);
        apart += (p[i] - q[i]) * (p[i] - q[i]), together += (p[i] + q[i]) * (p[i] + q[i]);
    }
    const double angle = 2 * std::atan2(std::sqrt(apart), std::sqrt(together));
    for (int i = 0; i < 4; ++i) {
        out[i] = angle == 0 ? p[i] : (std::sin((1 - t) * angle) * p[i] + std::sin(t * angle) * q[i]) / std::sin(angle);
        square += out[i] * out[i];
    }
    for (int i = 0; i < 4; ++i) out[i] /= std::sqrt(square);
}

glm::quat slerp(const glm::quat &a, const glm::quat &b, double f)
{
    const float x[4] = {a.x, a.y, a.z, a.w}, y[4] = {b.x, b.y, b.z, b.w};
    return math::slerp(x, y, f);
}

glm::quat random_unit(std::mt19937 &random)
{
    std::normal_distribution<double> normal;
    return unit_quat(normal(random), normal(random), normal(random), normal(random));
}

}  // namespace

TEST(Slerp, AgreesWithSinesAndArcCosinesOnArcsOfAnyLength)
{
    std::mt19937 random(1);
    double worst = 0;
    for (int i = 0; i < 200000; ++i) {
        const glm::quat a = random_unit(random);
        glm::quat b = random_unit(random);
        if (i % 2) {  // short arcs, as between keys
            const float reach = std::pow(10.0f, -float(i % 7));
            b = unit_quat(a.w + reach * b.w, a.x + reach * b.x, a.y + reach * b.y, a.z + reach * b.z);
        }
        const double t = (i % 1001) / 1000.0;
        double expected[4];
        reference(a, b, t, expected);
        const glm::quat q = slerp(a, b, t);
        const double got[4] = {q.w, q.x, q.y, q.z};
        for (int k = 0; k < 4; ++k) worst = std::max(worst, std::fabs(got[k] - expected[k]));
    }
    EXPECT_LT(worst, 1e-7);
    RecordProperty("worst", std::to_string(worst));
}

TEST(Slerp, GoesTheShorterWayRound)
{
    const glm::quat a(1, 0, 0, 0),
        b(-std::cos(0.1f), -std::sin(0.1f), 0, 0);  // b is 0.2 rad away, with the opposite sign
    EXPECT_NEAR(slerp(a, b, 0.5).x, std::sin(0.05), 1e-7);
}

TEST(Slerp, EndsAreTheKeys)
{
    std::mt19937 random(2);
    for (int i = 0; i < 1000; ++i) {
        const glm::quat a = random_unit(random), b = random_unit(random);
        for (int k = 0; k < 4; ++k) {
            EXPECT_NEAR(slerp(a, b, 0)[k], a[k], 1.2e-7);
            EXPECT_NEAR(std::fabs(slerp(a, b, 1)[k]), std::fabs(b[k]), 1.2e-7);
        }
    }
}

TEST(Slerp, OppositeKeysGiveSomeUnitRotation)
{
    const glm::quat q = slerp(glm::quat(1, 0, 0, 0), glm::quat(0, 1, 0, 0), 0.5);
    EXPECT_NEAR(q.w, std::sqrt(0.5), 1e-7);
    EXPECT_NEAR(q.x, std::sqrt(0.5), 1e-7);
    EXPECT_EQ(unit_quat(0, 0, 0, 0).w, 1);
}

}  // namespace claque::math
