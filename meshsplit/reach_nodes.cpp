// find_node_reach: bounds of every node's origin by best-first search (reach.h).
#include <algorithm>

#include <glm/geometric.hpp>

#include "meshsplit/reach.h"

namespace claque::meshsplit
{

using model::none;

namespace
{

// The sphere of an attached object need not be tight to a tenth of a per cent: so many precise evaluations per node are
// enough.
constexpr int max_evaluations = 24;

struct NodeCandidate {
    // bulge: towards neighbouring poses; not included in `bound` while poses are collected
    double bound = 0, bulge = 0;
    PoseAt at;
    bool evaluated = false;

    bool operator<(const NodeCandidate &other) const { return bound < other.bound; }
};

class NodeSearch
{
public:
    NodeSearch(const model::Rig &rig, const glm::dvec3 &centre)
        : rig_(rig),
          centre_(centre),
          solver_(rig),
          shifts_(max_shifts(rig)),
          poses_(rig.node_count()),
          stretches_(rig.node_count()),
          max_stretches_(rig.node_count())
    {
    }

    std::vector<model::NodeReach> run()
    {
        walk_poses(rig_, [this](const PoseAt &at, const Locals &locals, const PoseSegment *since) {
            solver_.set_pose(locals);
            for (uint32_t n = 0; n < rig_.node_count(); ++n) {
                collect(n, at, since);
                stretch(n, locals, since);
            }
        });
        LocalPoser poser(rig_);
        const Resolution resolution(2, rig_);
        std::vector<model::NodeReach> out;
        for (uint32_t n = 0; n < rig_.node_count(); ++n) {
            const double distance = settle(n, poser, resolution);
            out.push_back({float(distance * (1 + 1e-5)), float(max_stretches_[n] * (1 + 1e-5))});
        }
        return out;
    }

private:
    void collect(uint32_t n, const PoseAt &at, const PoseSegment *since)
    {
        MotionBound motion_bound;
        if (since)
            for (uint32_t k = n; k != none; k = rig_.parents[k])
                motion_bound = since->nodes[k].of(motion_bound, shifts_[k]);
        const double bulge = motion_bound.chord_deviation();
        if (since) poses_[n].back().bulge = std::max(poses_[n].back().bulge, bulge);
        poses_[n].push_back({solver_.origin_ball(n, centre_), bulge, at, !solver_.is_free(n)});
    }

    void stretch(uint32_t n, const Locals &locals, const PoseSegment *since)
    {
        stretches_[n] = since ? since->nodes[n].scale : NodeMotionBound(locals.nodes[n], locals.nodes[n]).scale;
        if (rig_.parents[n] != none) stretches_[n] *= stretches_[rig_.parents[n]];
        max_stretches_[n] = std::max(max_stretches_[n], stretches_[n]);
    }

    // Best-first search: all candidates that are not evaluated are below the result.
    double settle(uint32_t n, LocalPoser &poser, const Resolution &resolution)
    {
        std::vector<NodeCandidate> &heap = poses_[n];
        for (NodeCandidate &c : heap) c.bound += c.bulge;
        std::make_heap(heap.begin(), heap.end());
        for (int evaluations = 0; evaluations < max_evaluations && !heap.front().evaluated; ++evaluations) {
            std::pop_heap(heap.begin(), heap.end());
            NodeCandidate &best = heap.back();
            poser.pose(best.at, locals_);
            solver_.set_pose(locals_);
            solver_.origin_support(resolution, n, support_);
            best.bound = std::min(best.bound, farthest(resolution.directions, support_, centre_) + best.bulge);
            best.evaluated = true;
            std::push_heap(heap.begin(), heap.end());
        }
        return heap.front().bound;
    }

    const model::Rig &rig_;
    const glm::dvec3 centre_;
    ReachSolver solver_;
    const std::vector<double> shifts_;
    std::vector<std::vector<NodeCandidate>> poses_;  // per node
    std::vector<double> stretches_, max_stretches_;
    Locals locals_;
    Support support_;
};

}  // namespace

std::vector<model::NodeReach> find_node_reach(const model::Rig &rig, const glm::vec3 &centre)
{
    return NodeSearch(rig, glm::dvec3(centre)).run();
}

}  // namespace claque::meshsplit
