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
    uint32_t pose = 0;
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
          maps_(rig.node_count()),
          candidates_(rig.node_count()),
          settled_(rig.node_count()),
          stretches_(rig.node_count()),
          max_stretches_(rig.node_count())
    {
    }

    std::vector<model::NodeReach> run(uint64_t maximum)
    {
        const auto visit = [this](const PoseAt &at, const Locals &locals, const PoseSegment *since) {
            solver_.set_pose(locals);
            poses_.push_back(at);
            for (uint32_t n = 0; n < rig_.node_count(); ++n) {
                collect(n, since);
                stretch(n, locals, since);
            }
        };
        if (!walk_poses(rig_, visit, maximum)) return {};
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
    void collect(uint32_t n, const PoseSegment *since)
    {
        const uint32_t parent = rig_.parents[n];
        if (since) maps_[n] = MotionMap(parent == none ? MotionMap() : maps_[parent], since->nodes[n], shifts_[n]);
        const double bulge = since ? maps_[n].origin().chord_deviation() : 0;
        std::vector<NodeCandidate> &candidates = candidates_[n];
        if (since) candidates.back().bulge = std::max(candidates.back().bulge, bulge);
        const bool is_free = solver_.is_free(n);
        // Other nodes are where the ball says: only the largest counts.
        if (!is_free && !candidates.empty()) {
            settled_[n] = std::max(settled_[n], candidates.back().bound + candidates.back().bulge);
            candidates.clear();
        }
        const uint32_t pose = static_cast<uint32_t>(poses_.size() - 1);
        candidates.push_back({solver_.origin_ball(n, centre_), bulge, pose, !is_free});
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
        std::vector<NodeCandidate> &heap = candidates_[n];
        for (NodeCandidate &c : heap) c.bound += c.bulge;
        std::make_heap(heap.begin(), heap.end());
        for (int evaluations = 0; evaluations < max_evaluations && !heap.front().evaluated; ++evaluations) {
            std::pop_heap(heap.begin(), heap.end());
            NodeCandidate &best = heap.back();
            poser.pose(poses_[best.pose], locals_);
            solver_.set_pose(locals_);
            solver_.origin_support(resolution, n, support_);
            best.bound = std::min(best.bound, farthest(resolution.directions, support_, centre_) + best.bulge);
            best.evaluated = true;
            std::push_heap(heap.begin(), heap.end());
        }
        return std::max(settled_[n], heap.front().bound);
    }

    const model::Rig &rig_;
    const glm::dvec3 centre_;
    ReachSolver solver_;
    const std::vector<double> shifts_;
    std::vector<MotionMap> maps_;  // per node, of the motion to the pose that is visited
    std::vector<PoseAt> poses_;
    std::vector<std::vector<NodeCandidate>> candidates_;  // per node
    std::vector<double> settled_;                         // per node: a bound in poses that are no candidates any more
    std::vector<double> stretches_, max_stretches_;
    Locals locals_;
    Support support_;
};

}  // namespace

std::vector<model::NodeReach> find_node_reach(const model::Rig &rig, const glm::vec3 &centre, uint64_t maximum)
{
    return NodeSearch(rig, glm::dvec3(centre)).run(maximum);
}

}  // namespace claque::meshsplit
