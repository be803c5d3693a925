#include "tests/unit/parity/direct_flip.h"

#include <algorithm>
#include <cmath>

namespace parity_test
{
namespace
{

constexpr double pi = 3.141592653589793;
constexpr double illuminant[3] = {0.950428545, 1.0, 1.088900371};
constexpr double xyz_of_rgb[3][3] = {
    {0.41238656, 0.35759149, 0.18045049}, {0.21263682, 0.71518298, 0.0721802}, {0.01933062, 0.11919716, 0.95037259}};
constexpr double rgb_of_xyz[3][3] = {{3.241003275, -1.537398934, -0.498615861},
                                     {-0.969224334, 1.875930071, 0.041554224},
                                     {0.055639423, -0.204011202, 1.057148933}};

using Plane = std::vector<double>;

Rgb times(const double (&m)[3][3], const Rgb &v)
{
    Rgb out = {};
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) out[static_cast<size_t>(r)] += m[r][c] * v[static_cast<size_t>(c)];
    return out;
}

Rgb ycxcz(const Rgb &linear)
{
    const Rgb xyz = times(xyz_of_rgb, linear);
    const double x = xyz[0] / illuminant[0], y = xyz[1] / illuminant[1], z = xyz[2] / illuminant[2];
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Rgb linear_of_ycxcz(const Rgb &v)
{
    const double y = (v[0] + 16) / 116, x = y + v[1] / 500, z = y - v[2] / 200;
    return times(rgb_of_xyz, {x * illuminant[0], y * illuminant[1], z * illuminant[2]});
}

Rgb hunt_lab(const Rgb &linear)
{
    Rgb xyz = times(xyz_of_rgb, linear);
    for (size_t i = 0; i < 3; ++i) {
        const double t = xyz[i] / illuminant[i], delta = 6.0 / 29;
        xyz[i] = t > delta * delta * delta ? std::pow(t, 1.0 / 3) : t / (3 * delta * delta) + 4.0 / 29;
    }
    const double l = 116 * xyz[1] - 16;
    return {l, 0.01 * l * 500 * (xyz[0] - xyz[1]), 0.01 * l * 200 * (xyz[1] - xyz[2])};
}

double power_hyab(const Rgb &a, const Rgb &b)
{
    return std::pow(std::fabs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]), 0.7);
}

struct Square {
    int radius;
    Plane weights;
};

template <class Weight>
Square square(int radius, Weight weight)
{
    Square s = {radius, {}};
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) s.weights.push_back(weight(x, y));
    return s;
}

Square normalised(Square s)
{
    double positive = 0, negative = 0;
    for (const double w : s.weights) (w > 0 ? positive : negative) += std::fabs(w);
    for (double &w : s.weights) w /= w > 0 ? positive : std::max(negative, 1e-300);
    return s;
}

Plane convolved(const Plane &in, int width, int height, const Square &s)
{
    Plane out;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0;
            size_t k = 0;
            for (int v = -s.radius; v <= s.radius; ++v)
                for (int u = -s.radius; u <= s.radius; ++u) {
                    const int row = std::clamp(y + v, 0, height - 1), column = std::clamp(x + u, 0, width - 1);
                    sum += s.weights[k++] * in[static_cast<size_t>(row * width + column)];
                }
            out.push_back(sum);
        }
    return out;
}

Plane channel(const std::vector<Rgb> &picture, size_t c)
{
    Plane out;
    for (const Rgb &p : picture) out.push_back(ycxcz(p)[c]);
    return out;
}

std::vector<Rgb> perceived(const std::vector<Rgb> &picture, int width, int height, double ppd)
{
    const double a1[3] = {1, 1, 34.1}, b1[3] = {0.0047, 0.0053, 0.04}, a2[3] = {0, 0, 13.5},
                 b2[3] = {1e-5, 1e-5, 0.025};
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd));
    std::array<Plane, 3> planes;
    for (size_t c = 0; c < 3; ++c)
        planes[c] = convolved(channel(picture, c), width, height, normalised(square(radius, [&](int x, int y) {
                                  const double z = (x * x + y * y) / (ppd * ppd);
                                  return a1[c] * std::sqrt(pi / b1[c]) * std::exp(-pi * pi * z / b1[c]) +
                                         a2[c] * std::sqrt(pi / b2[c]) * std::exp(-pi * pi * z / b2[c]);
                              })));
    std::vector<Rgb> out;
    for (size_t i = 0; i < picture.size(); ++i) {
        Rgb linear = linear_of_ycxcz({planes[0][i], planes[1][i], planes[2][i]});
        for (double &v : linear) v = std::clamp(v, 0.0, 1.0);
        out.push_back(hunt_lab(linear));
    }
    return out;
}

// Lengths of the gradients that a kernel and the same kernel rotated by 90 degrees give.
Plane feature(const std::vector<Rgb> &picture, int width, int height, double ppd, bool point)
{
    const double sd = 0.5 * 0.082 * ppd;
    const int radius = static_cast<int>(std::ceil(3 * sd));
    const auto weight = [&](int x, int y) {
        return (point ? x * x / (sd * sd) - 1 : -x) * std::exp(-(x * x + y * y) / (2 * sd * sd));
    };
    Plane grey = channel(picture, 0);
    for (double &v : grey) v = (v + 16) / 116;
    const Plane across = convolved(grey, width, height, normalised(square(radius, weight)));
    const Plane down =
        convolved(grey, width, height, normalised(square(radius, [&](int x, int y) { return weight(y, x); })));
    Plane out;
    for (size_t i = 0; i < grey.size(); ++i) out.push_back(std::hypot(across[i], down[i]));
    return out;
}

}  // namespace

std::vector<double> direct_flip(const std::vector<Rgb> &reference, const std::vector<Rgb> &result, int width,
                                int height, double ppd)
{
    const std::vector<Rgb> a = perceived(reference, width, height, ppd), b = perceived(result, width, height, ppd);
    const Plane edges_a = feature(reference, width, height, ppd, false),
                edges_b = feature(result, width, height, ppd, false);
    const Plane points_a = feature(reference, width, height, ppd, true),
                points_b = feature(result, width, height, ppd, true);
    const double most = power_hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1}));
    std::vector<double> out;
    for (size_t i = 0; i < a.size(); ++i) {
        const double d = power_hyab(a[i], b[i]), knee = 0.4 * most;
        const double colour = d < knee ? 0.95 / knee * d : 0.95 + (d - knee) / (most - knee) * (1 - 0.95);
        const double features = std::max(std::fabs(edges_a[i] - edges_b[i]), std::fabs(points_a[i] - points_b[i]));
        out.push_back(std::pow(colour, 1 - std::pow(features / std::sqrt(2.0), 0.5)));
    }
    return out;
}

Rgb linear_of_srgb(int r, int g, int b)
{
    Rgb out = {};
    size_t i = 0;
    for (const int byte : {r, g, b}) {
        const double s = byte / 255.0;
        out[i++] = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    }
    return out;
}

}  // namespace parity_test
