#include "passes/close_samples.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lib/math/trig.h"

namespace claque::passes
{
namespace
{

constexpr int sides = 6, samples_a_side = 512;

// A triangle as a side's picture shows it.
struct Shown {
    glm::dvec2 at[3], uv[3];
    double area = 0;  // signed, twice; negative: seen from behind
};

Shown shown(const model::Level &level, const uint32_t *corners, glm::dvec3 right)
{
    Shown out;
    for (int k = 0; k < 3; ++k) {
        const float *p = &level.positions[3 * size_t(corners[k])], *uv = &level.uvs[2 * size_t(corners[k])];
        out.at[k] = {glm::dot(right, glm::dvec3(p[0], p[1], p[2])), double(p[1])};
        out.uv[k] = {uv[0], uv[1]};
    }
    const glm::dvec2 a = out.at[1] - out.at[0], b = out.at[2] - out.at[0];
    out.area = a.x * b.y - a.y * b.x;
    return out;
}

CloseSample sample_of(const Shown &triangle, uint32_t texture, double s, double t)
{
    if (s + t > 1) s = 1 - s, t = 1 - t;
    const glm::dvec2 a = triangle.at[1] - triangle.at[0], b = triangle.at[2] - triangle.at[0];
    const glm::dvec2 u = triangle.uv[1] - triangle.uv[0], v = triangle.uv[2] - triangle.uv[0];
    CloseSample sample;
    sample.texture = texture;
    sample.uv = triangle.uv[0] + s * u + t * v;
    sample.across = (b.y * u - a.y * v) / triangle.area;
    sample.up = (a.x * v - b.x * u) / triangle.area;
    return sample;
}

// Calls visit(shown, texture) for every triangle that faces a side.
template <class Visit>
void for_facing(const model::Level &level, glm::dvec3 right, Visit visit)
{
    for (const model::Surface &surface : level.surfaces) {
        const auto visit_range = [&](model::IndexRange range) {
            for (uint32_t i = range.first; i < range.first + range.count; i += 3) {
                const Shown triangle = shown(level, &level.indices[i], right);
                if (triangle.area > 0) visit(triangle, surface.texture);
            }
        };
        for (const model::Bin &bin : surface.clean) visit_range(bin.range);
        visit_range(surface.dirty);
    }
}

}  // namespace

std::vector<CloseSample> close_samples(const model::Level &level)
{
    std::vector<CloseSample> samples;
    for (int side = 0; side < sides; ++side) {
        const double angle = 2 * 3.14159265358979323846 * side / sides;
        const glm::dvec3 right(math::cos(angle), 0, math::sin(angle));
        double all = 0, passed = 0;
        for_facing(level, right, [&](const Shown &triangle, uint32_t) { all += triangle.area; });
        for_facing(level, right, [&](const Shown &triangle, uint32_t texture) {
            const double before = passed;
            passed += triangle.area / all * samples_a_side;
            for (double n = std::ceil(before); n < passed; ++n) {
                // Multiples of two irrational numbers spread evenly over any triangle.
                const double s = 0.7548776662466927 * n, t = 0.5698402909980532 * n;
                samples.push_back(sample_of(triangle, texture, s - std::floor(s), t - std::floor(t)));
            }
        });
    }
    return samples;
}

}  // namespace claque::passes
