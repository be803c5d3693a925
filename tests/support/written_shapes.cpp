#include "tests/support/written_shapes.h"

#include <cmath>

namespace claque::testing
{
namespace
{

constexpr float two_pi = 6.2831853f;

float dot(const Triple &a, const Triple &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// A unit vector at right angles to `axis`, the same for all axes that are nearly alike.
Triple across(const Triple &axis)
{
    return unit(cross(axis, std::fabs(axis[2]) < 0.9f ? Triple{0, 0, 1} : Triple{1, 0, 0}));
}

void add_vertex(Surface &surface, const Triple &position, const Triple &normal, float u, float v)
{
    surface.positions.push_back(position);
    surface.normals.push_back(normal);
    surface.uvs.push_back({u, v});
}

}  // namespace

Triple plus(const Triple &a, const Triple &b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Triple times(const Triple &a, float factor) { return {a[0] * factor, a[1] * factor, a[2] * factor}; }
Triple cross(const Triple &a, const Triple &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Triple unit(const Triple &a) { return times(a, 1 / std::sqrt(dot(a, a))); }

Surface tube(const std::vector<Ring> &rings, uint32_t sides, const UvBox &uv)
{
    Surface out;
    const size_t last = rings.size() - 1;
    const Triple axis = unit(plus(rings[last].centre, times(rings[0].centre, -1)));
    const Triple right = across(axis), front = cross(axis, right);
    for (size_t r = 0; r <= last; ++r) {
        const bool is_tip = r == 0 || r == last;
        const float radius = is_tip ? 0 : rings[r].radius;
        for (uint32_t s = 0; s <= sides; ++s) {
            const float angle = two_pi * static_cast<float>(s % sides) / static_cast<float>(sides);
            const Triple out_of = plus(times(right, std::cos(angle)), times(front, std::sin(angle)));
            const float lean = r == 0 ? -20.0f : r == last ? 20.0f : r == 1 ? -0.4f : r == last - 1 ? 0.4f : 0.0f;
            add_vertex(out, plus(rings[r].centre, times(out_of, radius)), unit(plus(out_of, times(axis, lean))),
                       uv.u0 + (uv.u1 - uv.u0) * static_cast<float>(s) / static_cast<float>(sides),
                       uv.v0 + (uv.v1 - uv.v0) * static_cast<float>(r) / static_cast<float>(last));
            if (!rings[r].influences.empty()) out.influences.push_back(rings[r].influences);
        }
    }
    for (uint32_t r = 0; r < last; ++r)
        for (uint32_t s = 0; s < sides; ++s) {
            const uint32_t a = r * (sides + 1) + s, b = a + sides + 1;
            if (r > 0) out.indices.insert(out.indices.end(), {a, a + 1, b});
            if (r + 1 < last) out.indices.insert(out.indices.end(), {a + 1, b + 1, b});
        }
    return out;
}

Surface sheet(const std::array<Triple, 4> &corners, uint32_t cells, const UvBox &uv)
{
    Surface out;
    const Triple normal = unit(cross(plus(corners[1], times(corners[0], -1)), plus(corners[3], times(corners[0], -1))));
    for (uint32_t j = 0; j <= cells; ++j)
        for (uint32_t i = 0; i <= cells; ++i) {
            const float x = static_cast<float>(i) / static_cast<float>(cells);
            const float y = static_cast<float>(j) / static_cast<float>(cells);
            const Triple low = plus(times(corners[0], 1 - x), times(corners[1], x));
            const Triple high = plus(times(corners[3], 1 - x), times(corners[2], x));
            add_vertex(out, plus(times(low, 1 - y), times(high, y)), normal, uv.u0 + (uv.u1 - uv.u0) * x,
                       uv.v0 + (uv.v1 - uv.v0) * y);
        }
    for (uint32_t j = 0; j < cells; ++j)
        for (uint32_t i = 0; i < cells; ++i) {
            const uint32_t a = j * (cells + 1) + i, b = a + cells + 1;
            out.indices.insert(out.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
        }
    return out;
}

Surface box(const Triple &centre, const Triple &half_size, const UvBox &uv)
{
    Surface out;
    for (size_t axis = 0; axis < 3; ++axis)
        for (const float sign : {-1.0f, 1.0f}) {
            const size_t other = (axis + 1) % 3, third = (axis + 2) % 3;
            std::array<Triple, 4> corners;
            for (size_t k = 0; k < 4; ++k) {
                corners[k][axis] = sign * half_size[axis];
                corners[k][other] = sign * (k == 1 || k == 2 ? half_size[other] : -half_size[other]);
                corners[k][third] = k >= 2 ? half_size[third] : -half_size[third];
                corners[k] = plus(corners[k], centre);
            }
            append(out, sheet(corners, 1, uv));
        }
    return out;
}

void append(Surface &to, const Surface &more)
{
    const uint32_t first = static_cast<uint32_t>(to.positions.size());
    to.positions.insert(to.positions.end(), more.positions.begin(), more.positions.end());
    to.normals.insert(to.normals.end(), more.normals.begin(), more.normals.end());
    to.uvs.insert(to.uvs.end(), more.uvs.begin(), more.uvs.end());
    to.influences.insert(to.influences.end(), more.influences.begin(), more.influences.end());
    for (const uint32_t index : more.indices) to.indices.push_back(first + index);
}

}  // namespace claque::testing
