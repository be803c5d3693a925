#include "lib/frame/spheres.h"

#include <cmath>

namespace claque::frame
{

using math::Containment;

namespace
{

struct Ball {
    glm::dvec3 centre;
    double radius = -1;  // negative: empty
};

double length_of(const glm::dvec3 &v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

Ball united(const Ball &a, const Ball &b)
{
    if (a.radius < 0) return b;
    if (b.radius < 0) return a;
    const glm::dvec3 way = b.centre - a.centre;
    const double apart = length_of(way);
    if (apart + b.radius <= a.radius) return a;
    if (apart + a.radius <= b.radius) return b;
    Ball out;
    out.radius = (apart + a.radius + b.radius) * 0.5;
    out.centre = a.centre + way * ((out.radius - a.radius) / apart);
    return out;
}

// An upper bound of how much the matrix stretches a length: the largest column of a similarity, else the Frobenius
// norm.
double max_scale_of(const math::Affine &m, bool similar)
{
    double maximum = 0, sum = 0;
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 c(m.column(k));
        const double square = c.x * c.x + c.y * c.y + c.z * c.z;
        sum += square;
        if (square > maximum) maximum = square;
    }
    return std::sqrt(similar ? maximum * (1 + 1e-3) : sum);
}

// A margin of a few bits more than float skinning may round away.
constexpr double margin = 1 + 1e-5;

Ball ball_of(const model::Template &tmpl, const model::Level &level, const model::LevelPart &part,
             const math::Affine *palette)
{
    Ball ball;
    for (uint32_t i = part.first_sphere; i < part.first_sphere + part.sphere_count; ++i) {
        const model::PartSphere &sphere = level.part_spheres[i];
        const math::Affine &m = palette[sphere.entry];
        Ball one;
        one.centre = glm::dvec3(math::transform_point(m, sphere.bind.centre));
        one.radius = double(sphere.bind.radius) * max_scale_of(m, tmpl.similar_only) * margin;
        ball = united(ball, one);
    }
    return ball;
}

constexpr uint32_t max_nodes = 256;  // beyond, parts are tested one by one, which keeps the stack small

}  // namespace

PartsInView parts_in_view(const model::Template &tmpl, const model::Level &level, const math::Affine *palette,
                          const ToFrustum &to, const math::Frustum &frustum)
{
    PartsInView out;
    const auto inside = [&](const Ball &ball) {
        ++out.tested;
        return test(frustum, to.origin + to.axes * ball.centre, ball.radius * to.scale);
    };
    Ball balls[model::max_level_parts];
    const uint32_t parts = static_cast<uint32_t>(level.parts.size());
    for (uint32_t k = 0; k < parts; ++k) balls[k] = ball_of(tmpl, level, level.parts[k], palette);
    out.built = parts;

    const uint32_t nodes = tmpl.rig.node_count();
    Containment state[max_nodes];
    const bool tree = parts > 2 && nodes <= max_nodes;
    if (tree) {
        Ball below[max_nodes];
        for (uint32_t k = 0; k < parts; ++k) below[level.parts[k].node] = united(below[level.parts[k].node], balls[k]);
        for (uint32_t n = nodes; n-- > 0;) {
            if (below[n].radius < 0) continue;
            ++out.built;
            if (const uint32_t parent = tmpl.rig.parents[n]; parent != model::none)
                below[parent] = united(below[parent], below[n]);
        }
        for (uint32_t n = 0; n < nodes; ++n) {
            const uint32_t parent = tmpl.rig.parents[n];
            state[n] = parent == model::none || below[parent].radius < 0 ? Containment::intersects : state[parent];
            if (state[n] == Containment::intersects && below[n].radius >= 0) state[n] = inside(below[n]);
        }
    }
    for (uint32_t k = 0; k < parts; ++k) {
        Containment where = tree ? state[level.parts[k].node] : Containment::intersects;
        if (where == Containment::intersects) where = inside(balls[k]);
        if (where != Containment::outside) out.parts |= uint64_t(1) << k;
    }
    return out;
}

}  // namespace claque::frame
