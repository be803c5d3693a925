#include "lib/math/slerp.h"

#include <cmath>

namespace claque::math
{

namespace
{

// sin(f a) / sin(a) as a series in x = cos(a) - 1, whose terms fall by x / 2 each: for x >= -0.08 six terms leave less
// than 1e-9. f2 = f * f.
double arc_weight(double f, double x)
{
    const double f2 = f * f;
    double sum = 1;
    for (int i = 6; i >= 1; --i) {
        const double u = 1.0 / (i * (2 * i + 1)), v = double(i) / (2 * i + 1);
        sum = 1 + (u * f2 - v) * x * sum;
    }
    return f * sum;
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
    const Quad q = mix(a, b, arc_weight(1 - f, cosine - 1), arc_weight(f, cosine - 1));
    return unit_quat(q.w, q.x, q.y, q.z);
}

}  // namespace claque::math
