#include "samples/scenes/odeon/noise.h"

#include <cmath>

#include "samples/scenes/random.h"

namespace scenes
{
namespace
{

// The dot product of a corner's gradient, which is one of the twelve edge midpoints of a cube, with the offset from
// that corner.
double corner(uint64_t seed, int64_t i, int64_t j, int64_t k, double x, double y, double z)
{
    const uint64_t cell = static_cast<uint64_t>(i) * 0x9e3779b97f4a7c15u ^
                          static_cast<uint64_t>(j) * 0xc2b2ae3d27d4eb4fu ^
                          static_cast<uint64_t>(k) * 0x165667b19e3779f9u;
    const uint64_t edge = random_bits(seed, cell, Purpose::gradient) % 12;
    const double a = edge & 1 ? 1 : -1, b = edge & 2 ? 1 : -1;
    return edge < 4 ? a * x + b * y : edge < 8 ? a * y + b * z : a * z + b * x;
}

double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }
double mix(double t, double a, double b) { return a + t * (b - a); }

}  // namespace

double gradient_noise(uint64_t seed, double x, double y, double z)
{
    const double fx = std::floor(x), fy = std::floor(y), fz = std::floor(z);
    const int64_t i = static_cast<int64_t>(fx), j = static_cast<int64_t>(fy), k = static_cast<int64_t>(fz);
    x -= fx, y -= fy, z -= fz;
    const double u = fade(x), v = fade(y), w = fade(z);
    double layer[2];
    for (int up = 0; up < 2; ++up)
        layer[up] =
            mix(v, mix(u, corner(seed, i, j, k + up, x, y, z - up), corner(seed, i + 1, j, k + up, x - 1, y, z - up)),
                mix(u, corner(seed, i, j + 1, k + up, x, y - 1, z - up),
                    corner(seed, i + 1, j + 1, k + up, x - 1, y - 1, z - up)));
    // Gradients have the length sqrt(2); corners are at most sqrt(3/4) away from the centre of a cell.
    const double bound = 1.2247448713915890;
    return mix(w, layer[0], layer[1]) / bound;
}

}  // namespace scenes
