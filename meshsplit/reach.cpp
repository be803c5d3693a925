#include "meshsplit/reach.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <queue>

namespace claque::meshsplit
{

namespace
{

constexpr size_t centre_poses = 64;

// A sphere that is larger than the smallest by this share is not worth a closer look.
constexpr double waste = 0.01;

// How well a pose has been looked at.
enum class BoundKind : uint8_t { ball, coarse, fine };

struct Candidate {
    double bound = 0;
    uint32_t pose = 0;
    BoundKind kind = BoundKind::ball;

    bool operator<(const Candidate &other) const
    {
        return bound != other.bound ? bound < other.bound : pose > other.pose;
    }
};

}  // namespace

FreeReach::FreeReach(const model::Template &tmpl)
    : tmpl_(tmpl), free_(tmpl), poser_(tmpl.rig), fill_(tmpl.rig), coarse_(2, tmpl.rig), fine_(3, tmpl.rig)
{
    find_poses();
}

void FreeReach::find_poses()
{
    const model::Rig &rig = tmpl_.rig;
    const std::vector<double> shifts = most_shifts(rig);
    std::vector<Drift> drifts(rig.node_count());
    std::vector<float> weights;
    walk_poses(rig, [&](const PoseAt &at, const Locals &locals, const Way *since) {
        double bulge = 0, way = std::numeric_limits<double>::infinity();
        if (since) {
            way = 0;
            std::fill(drifts.begin(), drifts.end(), Drift());
            for (const Body &body : free_.bodies)
                drifts[body.node()].take_in(body.drift(weights.data(), locals.weights.data(), *since));
            for (uint32_t n = rig.node_count(); n-- > 0;) {
                if (drifts[n].reach == 0) continue;
                const Drift drift = since->nodes[n].of(drifts[n], shifts[n]);
                if (rig.parents[n] == model::none)
                    bulge = std::max(bulge, drift.off_line()), way = std::max(way, drift.speed);
                else drifts[rig.parents[n]].take_in(drift);
            }
            bulges_.back() = std::max(bulges_.back(), bulge);
        }
        weights = locals.weights;
        poses_.push_back(at);
        bulges_.push_back(bulge);
        ways_.push_back(way);
    });
}

void FreeReach::look_at(uint32_t pose)
{
    poser_.pose(poses_[pose], locals_);
    fill_.take(locals_);
}

void FreeReach::own_supports(const Grain &grain, std::vector<Support> &own) const
{
    const bool first = own.empty();
    own.resize(free_.bodies.size());
    for (size_t b = 0; b < own.size(); ++b)
        if (first || free_.bodies[b].morphs())
            free_.bodies[b].support(grain.directions, free_.ranges, locals_.weights.data(), own[b]);
}

double FreeReach::bound_by(const Grain &grain, std::vector<Support> &own, const Fill::Enough &enough)
{
    const float *weights = locals_.weights.data();
    fill_.ball(free_.bodies, weights, enough.centre);
    own_supports(grain, own);
    const double left_out = fill_.support(grain, free_.bodies, weights, own, enough, all_);
    return std::max(left_out, farthest(grain.directions, all_, enough.centre));
}

glm::dvec3 FreeReach::centre(const std::vector<glm::dvec3> &points)
{
    const Directions &directions = coarse_.directions;
    Support most(directions.count(), -std::numeric_limits<double>::infinity());
    const size_t count = std::min(poses_.size(), centre_poses);
    for (size_t k = 0; k < count && !free_.bodies.empty(); ++k) {
        look_at(static_cast<uint32_t>(k * poses_.size() / count));
        bound_by(coarse_, own_coarse_, {glm::dvec3(0), 0});
        for (size_t i = 0; i < most.size(); ++i) most[i] = std::max(most[i], all_[i]);
    }
    for (const glm::dvec3 &p : points)
        for (size_t i = 0; i < most.size(); ++i) most[i] = std::max(most[i], glm::dot(directions[i], p));
    // The centre goes towards whatever stands out farthest, ever less.
    glm::dvec3 out(0);
    for (size_t i = 0; i < most.size(); ++i) out += directions[i] * (3 * most[i] / double(most.size()));
    for (int step = 1; step <= 2000; ++step) {
        size_t far = 0;
        double distance = -std::numeric_limits<double>::infinity();
        for (size_t i = 0; i < most.size(); ++i) {
            const double d = most[i] - glm::dot(directions[i], out);
            if (d > distance) distance = d, far = i;
        }
        out += directions[far] * (distance / double(step + 1));
    }
    return out;
}

// What is known of one pose is known of those beside it too, but for the way between them.
void FreeReach::tell(uint32_t pose, double bound, std::vector<double> &bounds) const
{
    const auto lower = [&](size_t i, double way) {
        if (bound + way + bulges_[i] >= bounds[i]) return false;
        bounds[i] = bound + way + bulges_[i];
        return true;
    };
    lower(pose, 0);
    double way = 0;
    for (size_t i = pose; i > 0 && lower(i - 1, way += ways_[i]);) --i;
    way = 0;
    for (size_t i = pose + 1; i < poses_.size() && lower(i, way += ways_[i]);) ++i;
}

double FreeReach::radius(const glm::dvec3 &centre, double reached)
{
    double found = reached;
    if (free_.bodies.empty()) return reached;
    std::vector<double> bounds;
    std::priority_queue<Candidate> queue;
    for (uint32_t i = 0; i < poses_.size(); ++i) {
        look_at(i);
        bounds.push_back(fill_.ball(free_.bodies, locals_.weights.data(), centre) + bulges_[i]);
        queue.push({bounds[i], i, BoundKind::ball});
    }
    while (queue.top().bound > found * (1 + waste)) {
        Candidate best = queue.top();
        if (best.bound <= bounds[best.pose]) {
            if (best.kind == BoundKind::fine) break;
            look_at(best.pose);
            const bool was_ball = best.kind == BoundKind::ball;
            const Fill::Enough near = {centre, found - bulges_[best.pose]};
            const double bound = was_ball ? bound_by(coarse_, own_coarse_, near) : bound_by(fine_, own_fine_, near);
            tell(best.pose, bound, bounds);
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
