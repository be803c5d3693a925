#include "samples/labels/variation/haze.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "samples/labels/projection.h"

namespace labels
{
namespace
{

constexpr double horizon[3] = {219, 224, 224}, ln_20 = 2.995732273553991, layer_m = 300, farthest_m = 30000;

}  // namespace

void add_haze(std::vector<uint8_t> &rgb, const std::vector<float> &depth, int width, int height,
              const clq_camera &camera, double visibility_m)
{
    const double extinction_per_m = ln_20 / visibility_m;
    const auto p = [&](size_t k) { return static_cast<double>(camera.projection[k]); };
    clq_camera turn = camera;
    for (double &e : turn.eye) e = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const size_t at = static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
            // The ray through the pixel's centre, one metre deep in eye space.
            const double u = 2 * (x + 0.5) / width - 1, v = 1 - 2 * (y + 0.5) / height;
            const std::array<double, 3> ray = {(u + p(8)) / p(0), (v + p(9)) / p(5), -1};
            const double length = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1] + 1);
            const double d = static_cast<double>(depth[at]);
            double path_m = 0;
            if (d < 1) path_m = length * p(14) / (2 * d - 1 + p(10));
            else {
                const double up = from_eye(turn, ray)[1] / length;
                path_m = up * farthest_m > layer_m ? layer_m / up : farthest_m;
            }
            const double left = std::exp(-extinction_per_m * std::clamp(path_m, 0.0, farthest_m));
            for (size_t k = 0; k < 3; ++k)
                rgb[3 * at + k] =
                    static_cast<uint8_t>(horizon[k] + left * (static_cast<double>(rgb[3 * at + k]) - horizon[k]) + 0.5);
        }
}

}  // namespace labels
