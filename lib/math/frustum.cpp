#include "lib/math/frustum.h"

#include <cmath>

namespace claque::math
{

Frustum frustum_of(const float projection[16], const Bounds &bounds)
{
    const double ends[6] = {bounds.left, bounds.right, bounds.bottom, bounds.top, -1, 1};
    const auto row = [&](int r, int c) { return double(projection[4 * c + r]); };
    Frustum out;
    for (int i = 0; i < 6; ++i) {
        // From left * w <= x, x <= right * w and so on: x - left * w >= 0, right * w - x >= 0.
        const int axis = i / 2;
        const double sign = i % 2 ? -1.0 : 1.0, end = -sign * ends[i];
        const auto term = [&](int c) { return end * row(3, c) + sign * row(axis, c); };
        const glm::dvec3 n(term(0), term(1), term(2));
        const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
        if (!(length > 1e-12)) continue;
        out.planes[out.count++] = Plane{n / length, term(3) / length};
    }
    return out;
}

Frustum rotated_back(const Frustum &frustum, const glm::dmat3 &turned)
{
    Frustum out = frustum;
    for (int i = 0; i < out.count; ++i) out.planes[i].normal = frustum.planes[i].normal * turned;
    return out;
}

Containment test_swept(const Frustum &frustum, const glm::dvec3 &c, double radius, const glm::dvec3 &sweep)
{
    Containment result = Containment::inside;
    for (int i = 0; i < frustum.count; ++i) {
        const Plane &p = frustum.planes[i];
        const double from = p.normal.x * c.x + p.normal.y * c.y + p.normal.z * c.z + p.offset;
        const double along = p.normal.x * sweep.x + p.normal.y * sweep.y + p.normal.z * sweep.z;
        const double to = from + along;
        if (from < -radius && to < -radius) return Containment::outside;
        if (from < radius || to < radius) result = Containment::intersects;
    }
    return result;
}

Containment test(const Frustum &frustum, const glm::dvec3 &c, double radius)
{
    Containment result = Containment::inside;
    for (int i = 0; i < frustum.count; ++i) {
        const Plane &p = frustum.planes[i];
        const double distance = p.normal.x * c.x + p.normal.y * c.y + p.normal.z * c.z + p.offset;
        if (distance < -radius) return Containment::outside;
        if (distance < radius) result = Containment::intersects;
    }
    return result;
}

}  // namespace claque::math
