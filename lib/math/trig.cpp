#include "lib/math/trig.h"

#include <cmath>

namespace claque::math
{

namespace
{

// For 0 <= x <= 1. Halving the angle twice brings x below 0.2, where the odd series to x^21 is exact to 1e-17.
double atan_unit(double x)
{
    for (int i = 0; i < 2; ++i) x = x / (1.0 + std::sqrt(1.0 + x * x));
    const double x2 = x * x;
    double sum = 0;
    for (int n = 21; n >= 1; n -= 2) sum = 1.0 / n - x2 * sum;
    return 4.0 * x * sum;
}

}  // namespace

double atan(double x)
{
    const double a = std::fabs(x);
    const double angle = a <= 1.0 ? atan_unit(a) : pi / 2 - atan_unit(1.0 / a);
    return x < 0 ? -angle : angle;
}

double atan2(double y, double x)
{
    const double ax = std::fabs(x), ay = std::fabs(y);
    if (ax == 0 && ay == 0) return 0;
    double angle = ay <= ax ? atan_unit(ay / ax) : pi / 2 - atan_unit(ax / ay);
    if (x < 0) angle = pi - angle;
    return y < 0 ? -angle : angle;
}

double acos(double x)
{
    if (x >= 1.0) return 0;
    if (x <= -1.0) return pi;
    return 2.0 * atan2(std::sqrt(1.0 - x), std::sqrt(1.0 + x));
}

double tan(double x) { return std::sin(x) / std::cos(x); }

}  // namespace claque::math
