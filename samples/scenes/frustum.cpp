#include "samples/scenes/frustum.h"

#include <cmath>

namespace scenes
{

Frustum::Frustum(const Eye &eye, float scale)
{
    double m[4][4];  // rows of projection times view
    for (size_t row = 0; row < 4; ++row)
        for (size_t column = 0; column < 4; ++column) {
            m[row][column] = 0;
            for (size_t k = 0; k < 4; ++k)
                m[row][column] += static_cast<double>(eye.projection[4 * k + row]) * eye.view[4 * column + k];
        }
    for (size_t plane = 0; plane < 6; ++plane) {
        const size_t axis = plane / 2;
        const double side = plane % 2 == 0 ? 1 : -1, wide = axis < 2 ? static_cast<double>(scale) : 1.0;
        double p[4], length = 0;
        for (size_t k = 0; k < 4; ++k) p[k] = wide * m[3][k] + side * m[axis][k];
        for (size_t k = 0; k < 3; ++k) length += p[k] * p[k];
        for (size_t k = 0; k < 4; ++k) planes_[plane][k] = static_cast<float>(p[k] / std::sqrt(length));
    }
}

bool Frustum::meets(const Sphere &s) const
{
    for (const std::array<float, 4> &p : planes_)
        if (p[0] * s.centre.x + p[1] * s.centre.y + p[2] * s.centre.z + p[3] < -s.radius) return false;
    return true;
}

}  // namespace scenes
