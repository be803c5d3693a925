#include "lib/math/slerp.h"

#include <cmath>

namespace claque::math
{

namespace
{

typedef double D2 __attribute__((vector_size(16)));

// sin(f a) / sin(a) for two f at once, as a series in x = cos(a) - 1 whose terms fall by x / 2 each: for x >= -0.08 six
// leave less than 1e-9. Between keys of a recorded motion x is above -0.002, where three do.
D2 arc_weights(D2 f, double x)
{
    const D2 f2 = f * f, one = {1, 1}, xx = {x, x};
    // Term i is the one before it times (f^2 - i^2) x / (i (2 i + 1)).
    const auto step = [&](double u, double v, D2 rest) { return one + (f2 * u - v) * xx * rest; };
    D2 sum = one;
    if (x < -0.002) sum = step(1.0 / 36, 4.0 / 9, step(1.0 / 55, 5.0 / 11, step(1.0 / 78, 6.0 / 13, one)));
    return f * step(1.0 / 3, 1.0 / 3, step(1.0 / 10, 2.0 / 5, step(1.0 / 21, 3.0 / 7, sum)));
}

struct Quad {
    double w, x, y, z;
};

Quad mix(const Quad &a, const Quad &b, double p, double q)
{
    return {p * a.w + q * b.w, p * a.x + q * b.x, p * a.y + q * b.y, p * a.z + q * b.z};
}

}  // namespace

glm::quat unit_quat(double w, double x, double y, double z)
{
    const double square = w * w + x * x + y * y + z * z;
    if (!(square > 0)) return glm::quat(1, 0, 0, 0);
    const double s = 1 / std::sqrt(square);
    return glm::quat(float(w * s), float(x * s), float(y * s), float(z * s));
}

glm::quat slerp(const glm::quat &first, const glm::quat &second, double f)
{
    Quad a{first.w, first.x, first.y, first.z}, b{second.w, second.x, second.y, second.z};
    double cosine = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
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
    const Quad q = mix(a, b, weights[0], weights[1]);
    return unit_quat(q.w, q.x, q.y, q.z);
}

}  // namespace claque::math
