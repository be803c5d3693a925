#include "lib/math/trig.h"

#include <cmath>
#include <cstdint>

namespace claque::math
{

namespace
{

// An angle as quarter turns and the rest, |rest + tail| <= pi / 4.
struct Reduced {
    double rest, tail;
    int64_t quarters;
};

// A quarter turn in three parts. The first two have 33 bits, so that their products with up to 2^20 are exact.
constexpr double quarter[3] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};

Reduced reduced(double angle)
{
    // Angles this large are farther from each other than the remainder is from the exact one.
    if (!(std::fabs(angle) < 1e6)) {
        if (!std::isfinite(angle)) return {NAN, 0, 0};
        angle = std::fmod(angle, 2 * pi);
    }
    constexpr double to_whole = 0x1.8p52;  // a double of this size has no fraction
    const double count = (angle * (2 / pi) + to_whole) - to_whole;
    const double a = angle - count * quarter[0], b = count * quarter[1], high = a - b;
    // Knuth's exact sum: a - b is high and its error.
    const double b_seen = a - high, error = (a - (high + b_seen)) + (b_seen - b);
    const double low = error - count * quarter[2], rest = high + low;
    return {rest, low - (rest - high), static_cast<int64_t>(count)};
}

// The series of sine and cosine up to x^17 and x^16, exact to 1e-18 for |x| <= pi / 4. Two chains take half the time.
double sine(const Reduced &r)
{
    const double x = r.rest, x2 = x * x, x4 = x2 * x2;
    const double even = 1 / 120.0 + x4 * (1 / 362880.0 + x4 * (1 / 6227020800.0 + x4 * (1 / 355687428096000.0)));
    const double odd = -1 / 5040.0 + x4 * (-1 / 39916800.0 + x4 * (-1 / 1307674368000.0));
    const double beyond = x2 * (even + x2 * odd) - 1 / 6.0;
    return x + (x * x2 * beyond + r.tail * (1 - 0.5 * x2));
}

double cosine(const Reduced &r)
{
    const double x = r.rest, x2 = x * x, x4 = x2 * x2;
    const double even = 1 / 24.0 + x4 * (1 / 40320.0 + x4 * (1 / 479001600.0 + x4 * (1 / 20922789888000.0)));
    const double odd = -1 / 720.0 + x4 * (-1 / 3628800.0 + x4 * (-1 / 87178291200.0));
    const double beyond = x4 * (even + x2 * odd), half = 0.5 * x2, first = 1 - half;
    return first + (((1 - first) - half) + (beyond - x * r.tail));  // (1 - first) - half is what `first` lost
}

double of_quarter(const Reduced &r, int64_t quarters)
{
    const double size = quarters & 1 ? cosine(r) : sine(r);
    return quarters & 2 ? -size : size;
}

// Sine of `angle` plus `more` quarter turns. The polynomials have the smallest error of their degree within a quarter
// turn. They are those of ARM's optimized routines (MIT), which glibc has taken over.
float of_quarter(float angle, int64_t more)
{
    const double x = static_cast<double>(angle);
    if (!(std::fabs(x) < 120)) {  // a product with a quarter turn of one part is too rough
        const Reduced r = reduced(x);
        return static_cast<float>(of_quarter(r, r.quarters + more));
    }
    const double count = std::floor(x * (2 / pi) + 0.5), rest = x - count * (pi / 2);
    const double x2 = rest * rest, x3 = rest * x2, x4 = x2 * x2;
    const int64_t quarters = static_cast<int64_t>(count) + more;
    double size;
    if (quarters & 1)
        size = ((1 - x2 * 0x1.ffffffd0c621cp-2) + x4 * 0x1.55553e1068f19p-5) +
               x4 * x2 * (x2 * 0x1.99343027bf8c3p-16 - 0x1.6c087e89a359dp-10);
    else size = (rest - x3 * 0x1.555545995a603p-3) + x3 * x2 * (0x1.1107605230bc4p-7 - x2 * 0x1.994eb3774cf24p-13);
    return static_cast<float>(quarters & 2 ? -size : size);
}

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

double sin(double x)
{
    const Reduced r = reduced(x);
    return of_quarter(r, r.quarters);
}

double cos(double x)
{
    const Reduced r = reduced(x);
    return of_quarter(r, r.quarters + 1);
}

float sin(float x) { return of_quarter(x, 0); }

float cos(float x) { return of_quarter(x, 1); }

double tan(double x)
{
    const Reduced r = reduced(x);
    return of_quarter(r, r.quarters) / of_quarter(r, r.quarters + 1);
}

// Each bit of the exponent's fraction stands for one more square root.
double pow(double x, double y)
{
    if (!(x > 0)) return 0;
    if (y < 0) return 1 / pow(x, -y);
    double out = 1, whole = std::floor(y), fraction = y - whole, power = x, root = x;
    for (; whole > 0; whole = std::floor(whole / 2), power *= power)
        if (std::fmod(whole, 2) != 0) out *= power;
    while (fraction > 0) {
        root = std::sqrt(root), fraction *= 2;
        if (fraction >= 1) out *= root, fraction -= 1;
    }
    return out;
}

}  // namespace claque::math
