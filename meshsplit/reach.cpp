#include "meshsplit/reach.h"

#include <algorithm>
#include <limits>
#include <queue>

#include <glm/geometric.hpp>

namespace claque::meshsplit
{

namespace
{

constexpr size_t centre_poses = 64;

// The relative gap between the sphere and its lower bound at which the search stops.
constexpr double sphere_tolerance = 0.01;

// How precisely a pose has been bounded.
enum class BoundKind : uint8_t { ball, coarse, fine };

struct PoseCandidate {
    double bound = 0;
    uint32_t pose = 0;
    BoundKind kind = BoundKind::ball;

    bool operator<(const PoseCandidate &other) const
    {
        return bound != other.bound ? bound < other.bound : pose > other.pose;
    }
};

}  // namespace

FreeReach::FreeReach(const model::Template &tmpl, uint64_t maximum)
    : tmpl_(tmpl), free_(tmpl), poser_(tmpl.rig), solver_(tmpl.rig), coarse_(2, tmpl.rig), fine_(3, tmpl.rig)
{
    if (!find_poses(maximum)) poses_.clear();
}

bool FreeReach::find_poses(uint64_t maximum)
{
    const model::Rig &rig = tmpl_.rig;
    const std::vector<double> shifts = max_shifts(rig);
    std::vector<MotionBound> motion_bounds(rig.node_count());
    std::vector<float> weights;
    const auto visit = [&](const PoseAt &at, const Locals &locals, const PoseSegment *since) {
        double bulge = 0, distance = std::numeric_limits<double>::infinity();
        if (since) {
            distance = 0;
            std::fill(motion_bounds.begin(), motion_bounds.end(), MotionBound());
            for (const PointSet &point_set : free_.point_sets)
                motion_bounds[point_set.node()].merge(
                    point_set.motion_bound(weights.data(), locals.weights.data(), *since));
            for (uint32_t n = rig.node_count(); n-- > 0;) {
                if (motion_bounds[n].reach == 0) continue;
                const MotionBound motion_bound = since->nodes[n].of(motion_bounds[n], shifts[n]);
                if (rig.parents[n] == model::none)
                    bulge = std::max(bulge, motion_bound.chord_deviation()),
                    distance = std::max(distance, motion_bound.speed);
                else motion_bounds[rig.parents[n]].merge(motion_bound);
            }
            bulges_.back() = std::max(bulges_.back(), bulge);
        }
        weights = locals.weights;
        poses_.push_back(at);
        bulges_.push_back(bulge);
        distances_.push_back(distance);
    };
    return walk_poses(rig, visit, maximum);
}

void FreeReach::look_at(uint32_t pose)
{
    poser_.pose(poses_[pose], locals_);
    solver_.set_pose(locals_);
}

void FreeReach::own_supports(const Resolution &resolution, std::vector<Support> &own) const
{
    const bool first = own.empty();
    own.resize(free_.point_sets.size());
    for (size_t b = 0; b < own.size(); ++b)
        if (first || free_.point_sets[b].morphs())
            free_.point_sets[b].support(resolution.directions, free_.ranges, locals_.weights.data(), own[b]);
}

double FreeReach::bound_by(const Resolution &resolution, std::vector<Support> &own, const ReachSolver::Cutoff &cutoff)
{
    const float *weights = locals_.weights.data();
    solver_.ball(free_.point_sets, weights, cutoff.centre);
    own_supports(resolution, own);
    const double left_out = solver_.support(resolution, free_.point_sets, weights, own, cutoff, all_);
    return std::max(left_out, farthest(resolution.directions, all_, cutoff.centre));
}

glm::dvec3 FreeReach::centre(const std::vector<glm::dvec3> &points)
{
    const Directions &directions = coarse_.directions;
    Support maximum(directions.count(), -std::numeric_limits<double>::infinity());
    const size_t count = std::min(poses_.size(), centre_poses);
    for (size_t k = 0; k < count && !free_.point_sets.empty(); ++k) {
        look_at(static_cast<uint32_t>(k * poses_.size() / count));
        bound_by(coarse_, own_coarse_, {glm::dvec3(0), 0});
        for (size_t i = 0; i < maximum.size(); ++i) maximum[i] = std::max(maximum[i], all_[i]);
    }
    for (const glm::dvec3 &p : points)
        for (size_t i = 0; i < maximum.size(); ++i) maximum[i] = std::max(maximum[i], glm::dot(directions[i], p));
    // Moves the centre towards the direction of the largest distance in ever smaller steps.
    glm::dvec3 out(0);
    for (size_t i = 0; i < maximum.size(); ++i) out += directions[i] * (3 * maximum[i] / double(maximum.size()));
    for (int step = 1; step <= 2000; ++step) {
        size_t far = 0;
        double distance = -std::numeric_limits<double>::infinity();
        for (size_t i = 0; i < maximum.size(); ++i) {
            const double d = maximum[i] - glm::dot(directions[i], out);
            if (d > distance) distance = d, far = i;
        }
        out += directions[far] * (distance / double(step + 1));
    }
    return out;
}

// A bound of one pose also bounds its neighbours, plus the distance between them.
void FreeReach::propagate(uint32_t pose, double bound, std::vector<double> &bounds) const
{
    const auto lower = [&](size_t i, double distance) {
        if (bound + distance + bulges_[i] >= bounds[i]) return false;
        bounds[i] = bound + distance + bulges_[i];
        return true;
    };
    lower(pose, 0);
    double distance = 0;
    for (size_t i = pose; i > 0 && lower(i - 1, distance += distances_[i]);) --i;
    distance = 0;
    for (size_t i = pose + 1; i < poses_.size() && lower(i, distance += distances_[i]);) ++i;
}

double FreeReach::radius(const glm::dvec3 &centre, double reached, uint64_t precise)
{
    double found = reached;
    if (free_.point_sets.empty()) return reached;
    std::vector<double> bounds;
    std::priority_queue<PoseCandidate> queue;
    for (uint32_t i = 0; i < poses_.size(); ++i) {
        look_at(i);
        bounds.push_back(solver_.ball(free_.point_sets, locals_.weights.data(), centre) + bulges_[i]);
        queue.push({bounds[i], i, BoundKind::ball});
    }
    while (queue.top().bound > found * (1 + sphere_tolerance)) {
        PoseCandidate best = queue.top();
        if (best.bound <= bounds[best.pose]) {
            if (best.kind == BoundKind::fine || precise-- == 0) break;
            look_at(best.pose);
            const bool was_ball = best.kind == BoundKind::ball;
            const ReachSolver::Cutoff near = {centre, found - bulges_[best.pose]};
            const double bound = was_ball ? bound_by(coarse_, own_coarse_, near) : bound_by(fine_, own_fine_, near);
            propagate(best.pose, bound, bounds);
            if (!was_ball) found = std::max(found, bound);
            best.kind = was_ball ? BoundKind::coarse : BoundKind::fine;
        }
        best.bound = bounds[best.pose];
        queue.pop();
        queue.push(best);
    }
    return std::max(reached, queue.top().bound);
}

}  // namespace claque::meshsplit
