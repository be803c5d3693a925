#include "meshsplit/reach_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "meshsplit/largest.h"

namespace claque::meshsplit
{

using model::none;

namespace
{

constexpr double nothing = -std::numeric_limits<double>::infinity();

AffineMap placed(const math::Trs &trs)
{
    return {glm::dmat3(glm::mat3_cast(glm::dquat(trs.rotation))), glm::dvec3(trs.translation)};
}

AffineMap scaled(const AffineMap &map, const glm::vec3 &scale)
{
    AffineMap out = map;
    for (int k = 0; k < 3; ++k) out.turn[k] *= double(scale[k]);
    return out;
}

glm::dvec3 moved(const AffineMap &map, const glm::dvec3 &p) { return map.turn * p + map.move; }

}  // namespace

Resolution::Resolution(int splits, const model::Rig &rig) : directions(splits)
{
    for (const model::Dof &dof : rig.dofs) sweeps.emplace_back(directions, dof);
}

ReachSolver::ReachSolver(const model::Rig &rig)
    : rig_(rig), joint_of_(rig.node_count(), none), to_joint_(rig.node_count()), stretch_(rig.node_count(), 1)
{
    const std::vector<double> shifts = max_shifts(rig);
    for (uint32_t n = 0; n < rig.node_count(); ++n) {
        const uint32_t above = rig.parents[n] == none ? none : joint_of_[rig.parents[n]];
        FreeJoint joint;
        joint.node = n, joint.above = above, joint.shift = shifts[n];
        for (uint32_t d = static_cast<uint32_t>(rig.dofs.size()); d-- > 0;)
            if (rig.dofs[d].kind != model::DofKind::morph && rig.dofs[d].node == n) joint.dofs.push_back(d);
        joint_of_[n] = joint.dofs.empty() ? above : static_cast<uint32_t>(joints_.size());
        if (!joint.dofs.empty()) joints_.push_back(joint);
    }
    reach_.resize(joints_.size());
    reached_.resize(joints_.size());
    sets_.resize(joints_.size());
}

void ReachSolver::set_pose(const Locals &locals)
{
    uint32_t next = 0;
    for (uint32_t n = 0; n < rig_.node_count(); ++n) {
        const math::Trs &trs = locals.nodes[n];
        const uint32_t parent = rig_.parents[n];
        AffineMap map = placed(trs);
        double stretch = largest(trs.scale);
        if (parent != none) map = after(to_joint_[parent], map);
        if (next < joints_.size() && joints_[next].node == n) {
            joints_[next].lift = map;
            joints_[next].lift_stretch = parent == none ? 1 : stretch_[parent];
            map = AffineMap();
            ++next;
        } else if (parent != none) {
            stretch *= stretch_[parent];
        }
        to_joint_[n] = scaled(map, trs.scale);
        stretch_[n] = stretch;
    }
}

double ReachSolver::ball(const std::vector<PointSet> &point_sets, const float *weights, const glm::dvec3 &centre)
{
    double maximum = 0;
    std::fill(reach_.begin(), reach_.end(), nothing);
    for (const PointSet &point_set : point_sets) {
        const uint32_t n = point_set.node(), s = joint_of_[n];
        const glm::dvec3 at = moved(to_joint_[n], point_set.centre());
        const double radius = stretch_[n] * point_set.radius(weights);
        if (s == none) maximum = std::max(maximum, glm::distance(at, centre) + radius);
        else reach_[s] = std::max(reach_[s], glm::length(at) + radius);
    }
    for (size_t s = joints_.size(); s-- > 0;) {
        const FreeJoint &joint = joints_[s];
        if (reach_[s] == nothing) continue;
        reach_[s] += joint.shift;
        const double radius = joint.lift_stretch * reach_[s];
        if (joint.above == none) maximum = std::max(maximum, glm::distance(joint.lift.move, centre) + radius);
        else reach_[joint.above] = std::max(reach_[joint.above], glm::length(joint.lift.move) + radius);
    }
    return maximum;
}

// Sweeps the set of a joint over its degrees of freedom, in the frame of its own position and rotation.
void ReachSolver::sweep(const Resolution &resolution, const FreeJoint &joint, double reach, Support &set)
{
    const double tight = resolution.directions.max_weight() * *std::max_element(set.begin(), set.end()) + joint.shift;
    for (const uint32_t d : joint.dofs) resolution.sweeps[d].sweep(std::min(reach, tight), set, scratch_);
}

double ReachSolver::support(const Resolution &resolution, const std::vector<PointSet> &point_sets, const float *weights,
                            const std::vector<Support> &own, const Cutoff &cutoff, Support &out)
{
    double left_out = 0;
    const auto add = [&](const Support &set, const AffineMap &map, uint32_t to) {
        Support &target = to == none ? out : sets_[to];
        if (to != none && !reached_[to]) target.assign(out.size(), nothing), reached_[to] = 1;
        merge(resolution.directions, set, map, target);
    };
    out.assign(resolution.directions.count(), nothing);
    std::fill(reached_.begin(), reached_.end(), uint8_t(0));
    for (size_t b = 0; b < point_sets.size(); ++b) {
        const uint32_t n = point_sets[b].node();
        const double bound = ball_of(n, point_sets[b].centre(), point_sets[b].radius(weights), cutoff.centre);
        if (bound <= cutoff.distance) left_out = std::max(left_out, bound);
        else add(own[b], to_joint_[n], joint_of_[n]);
    }
    for (size_t s = joints_.size(); s-- > 0;) {
        if (!reached_[s]) continue;
        sweep(resolution, joints_[s], reach_[s], sets_[s]);
        add(sets_[s], joints_[s].lift, joints_[s].above);
    }
    return left_out;
}

// For a ball in a node's frame: joints rotate it about themselves in any case.
double ReachSolver::ball_of(uint32_t node, const glm::dvec3 &p, double radius, const glm::dvec3 &centre) const
{
    glm::dvec3 at = moved(to_joint_[node], p);
    radius *= stretch_[node];
    for (uint32_t s = joint_of_[node]; s != none; s = joints_[s].above) {
        radius = joints_[s].lift_stretch * (radius + glm::length(at) + joints_[s].shift);
        at = joints_[s].lift.move;
    }
    return glm::distance(at, centre) + radius;
}

double ReachSolver::origin_ball(uint32_t node, const glm::dvec3 &centre) const
{
    return ball_of(node, glm::dvec3(0), 0, centre);
}

void ReachSolver::origin_support(const Resolution &resolution, uint32_t node, Support &out)
{
    const auto at_point = [&](const glm::dvec3 &p) {
        for (size_t i = 0; i < out.size(); ++i) out[i] = glm::dot(resolution.directions[i], p);
    };
    out.resize(resolution.directions.count());
    at_point(to_joint_[node].move);
    double reach = glm::length(to_joint_[node].move);
    for (uint32_t s = joint_of_[node]; s != none; s = joints_[s].above) {
        reach += joints_[s].shift;
        sweep(resolution, joints_[s], reach, out);
        Support &lifted = sets_[s];
        lifted.assign(out.size(), nothing);
        merge(resolution.directions, out, joints_[s].lift, lifted);
        out.swap(lifted);
        reach = glm::length(joints_[s].lift.move) + joints_[s].lift_stretch * reach;
    }
}

}  // namespace claque::meshsplit
