#include "meshsplit/blend_reach.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "lib/math/affine.h"
#include "meshsplit/enclosing.h"
#include "meshsplit/largest.h"
#include "meshsplit/reach_poses.h"

namespace claque::meshsplit
{

using model::none;

namespace
{

// Margin for rounding and the stated errors of resampled motion.
constexpr double margin = 1.002;

// Bounds of one node in all blends whose additive weights sum to `added`.
struct NodeBall {
    glm::dvec3 centre;  // of its origin, or of that of an ancestor
    double radius = 0;
    double stretch = 1;  // scale of what it moves
    bool fixed = true;   // no blend rotates or scales its frame, which is the rest frame
    math::Affine frame;  // at rest
};

std::vector<NodeBall> balls_of(const model::Rig &rig, const std::vector<NodeExtent> &extents, double added)
{
    std::vector<NodeBall> out(rig.node_count());
    for (uint32_t n = 0; n < rig.node_count(); ++n) {
        const NodeExtent &extent = extents[n];
        const uint32_t parent = rig.parents[n];
        const NodeBall above = parent == none ? NodeBall{glm::dvec3(0), 0, 1, true, math::Affine()} : out[parent];
        NodeBall &ball = out[n];
        ball = above;
        ball.frame = math::mul(above.frame, math::affine_of(rig.rest[n]));
        const double strays = extent.offset_range * (1 + 2 * added) + extent.shift;
        if (above.fixed) {
            ball.centre = glm::dvec3(ball.frame.column(3));
            ball.radius = above.radius + above.stretch * strays;
        } else {
            const double away = std::min(extent.offset + 2 * added * extent.offset_range + extent.shift,
                                         glm::length(glm::dvec3(rig.rest[n].translation)) + strays);
            ball.radius = above.radius + above.stretch * away;
        }
        ball.stretch = above.stretch * (extent.scale + 2 * added * extent.scale_range);
        ball.fixed = above.fixed && !extent.turns && extent.scale_range == 0;
    }
    return out;
}

double stretch_of(const math::Affine &m)
{
    double sum = 0;
    for (const float x : m.c) sum += double(x) * x;
    const glm::dvec3 t(m.column(3));
    return std::sqrt(std::max(0.0, sum - glm::dot(t, t)));
}

double radius_of(const model::Template &tmpl, const std::vector<NodeBall> &balls, double added)
{
    const glm::dvec3 middle(tmpl.sklsroot.centre);
    // Additive weights of morph targets may move vertices outside of their spheres.
    const double morphs = tmpl.rig.rest_weights.empty() ? 1 : 1 + 4 * added;
    double maximum = 0;
    for (const model::Level &level : tmpl.levels)
        for (const model::PartSphere &sphere : level.part_spheres) {
            const model::PaletteEntry &entry = tmpl.rig.palette[sphere.entry];
            const NodeBall &ball = balls[entry.node];
            const glm::vec3 centre = math::transform_point(entry.inverse_bind, sphere.bind.centre);
            const double radius = double(sphere.bind.radius) * stretch_of(entry.inverse_bind) * morphs;
            if (ball.fixed) {
                const glm::dvec3 at(math::transform_point(ball.frame, centre));
                maximum = std::max(maximum, glm::distance(at, middle) + ball.radius + ball.stretch * radius);
            } else {
                const double own = glm::length(glm::dvec3(centre)) + radius;
                maximum = std::max(maximum, glm::distance(ball.centre, middle) + ball.radius + ball.stretch * own);
            }
        }
    return maximum;
}

std::vector<NodeExtent> rest_extents(const model::Rig &rig)
{
    std::vector<NodeExtent> out(rig.node_count());
    const std::vector<double> shifts = max_shifts(rig);
    for (uint32_t n = 0; n < rig.node_count(); ++n) {
        out[n].shift = shifts[n];
        out[n].scale = largest(rig.rest[n].scale);
        out[n].offset = glm::length(glm::dvec3(rig.rest[n].translation));
    }
    for (const model::Dof &dof : rig.dofs)
        if (dof.kind == model::DofKind::rotation) out[dof.node].turns = true;
    return out;
}

}  // namespace

std::vector<NodeExtent> node_extents(const model::Rig &rig, uint64_t maximum)
{
    std::vector<NodeExtent> out = rest_extents(rig);
    const auto visit = [&](const PoseAt &, const Locals &locals, const PoseSegment *since) {
        for (uint32_t n = 0; n < rig.node_count(); ++n) {
            const math::Trs &now = locals.nodes[n], &rest = rig.rest[n];
            const NodeMotionBound motion_bound = since ? since->nodes[n] : NodeMotionBound(now, now);
            NodeExtent &extent = out[n];
            extent.offset = std::max(extent.offset, motion_bound.offset);
            extent.scale = std::max(extent.scale, motion_bound.scale);
            extent.offset_range =
                std::max(extent.offset_range, glm::distance(glm::dvec3(now.translation), glm::dvec3(rest.translation)) +
                                                  motion_bound.travel_acceleration / 8);
            extent.scale_range =
                std::max(extent.scale_range, largest(now.scale - rest.scale) + motion_bound.scale_acceleration / 8);
            extent.turns = extent.turns || now.rotation != rest.rotation;
        }
    };
    if (!walk_poses(rig, visit, maximum)) out.clear();
    return out;
}

std::vector<NodeExtent> key_extents(const model::Rig &rig)
{
    std::vector<NodeExtent> out = rest_extents(rig);
    for (uint32_t c = 0; c < rig.clips.size(); ++c) add_clip(rig, c, out);
    return out;
}

void find_blend_reach(const std::vector<NodeExtent> &extents, model::Template &tmpl)
{
    const std::vector<NodeBall> none_added = balls_of(tmpl.rig, extents, 0);
    const std::vector<NodeBall> added = balls_of(tmpl.rig, extents, double(model::max_additive_weight));
    const glm::dvec3 middle(tmpl.sklsroot.centre);
    // The bounds are polynomials of `added` without negative terms, so the chord lies above them.
    const auto chord = [](double from, double to) {
        return model::AdditiveBound{float(from * margin),
                                    float(margin * (to - from) / double(model::max_additive_weight))};
    };
    tmpl.blend_radius =
        chord(radius_of(tmpl, none_added, 0), radius_of(tmpl, added, double(model::max_additive_weight)));
    tmpl.blend_radius.base = std::max(tmpl.blend_radius.base, tmpl.sklsroot.radius);
    tmpl.blend_reach.clear();
    for (uint32_t n = 0; n < tmpl.rig.node_count(); ++n) {
        const NodeBall &a = none_added[n], &b = added[n];
        tmpl.blend_reach.push_back(
            {chord(glm::distance(a.centre, middle) + a.radius, glm::distance(b.centre, middle) + b.radius),
             chord(a.stretch, b.stretch)});
    }
}

void bound_by_lengths(const std::vector<NodeExtent> &extents, model::Template &tmpl)
{
    const std::vector<NodeBall> balls = balls_of(tmpl.rig, extents, 0);
    std::vector<Ball> at_rest;
    for (const model::Level &level : tmpl.levels)
        for (const model::PartSphere &sphere : level.part_spheres) {
            const model::PaletteEntry &entry = tmpl.rig.palette[sphere.entry];
            const glm::vec3 centre = math::transform_point(entry.inverse_bind, sphere.bind.centre);
            at_rest.push_back({glm::dvec3(math::transform_point(balls[entry.node].frame, centre)), 0});
        }
    if (!at_rest.empty()) tmpl.sklsroot.centre = enclosing(at_rest).centre;
    tmpl.sklsroot.radius = static_cast<float>(margin * radius_of(tmpl, balls, 0));
    const glm::dvec3 middle(tmpl.sklsroot.centre);
    tmpl.node_reach.clear();
    for (const NodeBall &ball : balls)
        tmpl.node_reach.push_back({static_cast<float>(margin * (glm::distance(ball.centre, middle) + ball.radius)),
                                   static_cast<float>(margin * ball.stretch)});
}

}  // namespace claque::meshsplit
