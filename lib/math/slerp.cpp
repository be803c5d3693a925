#include "lib/math/slerp.h"

#include <cmath>

namespace claque::math
{

namespace
{

typedef double D2 __attribute__((vector_size(16)));

// sin(f a) / sin(a) for two f at once, as a series in x = cos(a) - 1 whose terms fall by x / 2 each. For x >= -0.08 six
// terms leave an error below 1e-9. Between keys of a recorded motion x is above -0.002, where three suffice.
D2 arc_weights(D2 f, double x)
{
    const D2 f2 = f * f, one = {1, 1}, xx = {x, x};
    // Term i is the previous one times (f^2 - i^2) x / (i (2 i + 1)).
    const auto step = [&](double u, double v, D2 rest) { return one + (f2 * u - v) * xx * rest; };
    D2 sum = one;
    if (x < -0.002) sum = step(1.0 / 36, 4.0 / 9, step(1.0 / 55, 5.0 / 11, step(1.0 / 78, 6.0 / 13, one)));
    return f * step(1.0 / 3, 1.0 / 3, step(1.0 / 10, 2.0 / 5, step(1.0 / 21, 3.0 / 7, sum)));
}

// A quaternion in double, as two pairs.
struct Quad {
    D2 xy, zw;
};

Quad quad_of(const float xyzw[4]) { return {D2{xyzw[0], xyzw[1]}, D2{xyzw[2], xyzw[3]}}; }

double dot(const Quad &a, const Quad &b)
{
    const D2 sum = a.xy * b.xy + a.zw * b.zw;
    return sum[0] + sum[1];
}

Quad mix(const Quad &a, const Quad &b, double p, double q) { return {p * a.xy + q * b.xy, p * a.zw + q * b.zw}; }

glm::quat unit_of(const Quad &q)
{
    const double square = dot(q, q);
    if (!(square > 0)) return glm::quat(1, 0, 0, 0);
    const double s = 1 / std::sqrt(square);
    const D2 xy = q.xy * s, zw = q.zw * s;
    return glm::quat(float(zw[1]), float(xy[0]), float(xy[1]), float(zw[0]));
}

}  // namespace

glm::quat unit_quat(double w, double x, double y, double z) { return unit_of({D2{x, y}, D2{z, w}}); }

glm::quat slerp(const float first[4], const float second[4], double f)
{
    Quad a = quad_of(first), b = quad_of(second);
    double cosine = dot(a, b);
    if (cosine < 0) {
        b = mix(a, b, 0, -1);
        cosine = -cosine;
    }
    if (cosine > 1) cosine = 1;
    // Long arcs are halved, exactly, until the series is short: at most twice from a right angle.
    while (cosine < 0.92) {
        const double s = 1 / std::sqrt(2 + 2 * cosine);
        const Quad middle = mix(a, b, s, s);
        cosine = std::sqrt((1 + cosine) / 2);
        const bool far_half = f > 0.5;
        (far_half ? a : b) = middle;
        f = far_half ? 2 * f - 1 : 2 * f;
    }
    const D2 weights = arc_weights(D2{1 - f, f}, cosine - 1);
    return unit_of(mix(a, b, weights[0], weights[1]));
}

}  // namespace claque::math
