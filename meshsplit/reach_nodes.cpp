#include "meshsplit/reach.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace claque::meshsplit
{

using model::none;

namespace
{

// An object's sphere needs no tenth of a percent: so many closer looks a node are enough.
constexpr int most_looks = 24;

struct NodeCandidate {
    double bound = 0, bulge = 0;  // bulge: towards the poses beside it, not in the bound while poses are collected
    PoseAt at;
    bool looked_at = false;

    bool operator<(const NodeCandidate &other) const { return bound < other.bound; }
};

class NodeSearch
{
public:
    NodeSearch(const model::Rig &rig, const glm::dvec3 &centre)
        : rig_(rig),
          centre_(centre),
          fill_(rig),
          shifts_(most_shifts(rig)),
          poses_(rig.node_count()),
          stretches_(rig.node_count()),
          most_stretched_(rig.node_count())
    {
    }

    std::vector<model::NodeReach> run()
    {
        walk_poses(rig_, [this](const PoseAt &at, const Locals &locals, const Way *since) {
            fill_.take(locals);
            for (uint32_t n = 0; n < rig_.node_count(); ++n) {
                take(n, at, since);
                stretch(n, locals, since);
            }
        });
        LocalPoser poser(rig_);
        const Grain grain(2, rig_);
        std::vector<model::NodeReach> out;
        for (uint32_t n = 0; n < rig_.node_count(); ++n) {
            const double distance = settle(n, poser, grain);
            out.push_back({float(distance * (1 + 1e-5)), float(most_stretched_[n] * (1 + 1e-5))});
        }
        return out;
    }

private:
    void take(uint32_t n, const PoseAt &at, const Way *since)
    {
        Drift drift;
        if (since)
            for (uint32_t k = n; k != none; k = rig_.parents[k]) drift = since->nodes[k].of(drift, shifts_[k]);
        const double bulge = drift.off_line();
        if (since) poses_[n].back().bulge = std::max(poses_[n].back().bulge, bulge);
        poses_[n].push_back({fill_.origin_ball(n, centre_), bulge, at, !fill_.is_free(n)});
    }

    void stretch(uint32_t n, const Locals &locals, const Way *since)
    {
        stretches_[n] = since ? since->nodes[n].scale : NodeDrift(locals.nodes[n], locals.nodes[n]).scale;
        if (rig_.parents[n] != none) stretches_[n] *= stretches_[rig_.parents[n]];
        most_stretched_[n] = std::max(most_stretched_[n], stretches_[n]);
    }

    // Best first: whatever is left unlooked at is below what comes out.
    double settle(uint32_t n, LocalPoser &poser, const Grain &grain)
    {
        std::vector<NodeCandidate> &heap = poses_[n];
        for (NodeCandidate &c : heap) c.bound += c.bulge;
        std::make_heap(heap.begin(), heap.end());
        for (int looks = 0; looks < most_looks && !heap.front().looked_at; ++looks) {
            std::pop_heap(heap.begin(), heap.end());
            NodeCandidate &best = heap.back();
            poser.pose(best.at, locals_);
            fill_.take(locals_);
            fill_.origin_support(grain, n, support_);
            best.bound = std::min(best.bound, farthest(grain.directions, support_, centre_) + best.bulge);
            best.looked_at = true;
            std::push_heap(heap.begin(), heap.end());
        }
        return heap.front().bound;
    }

    const model::Rig &rig_;
    const glm::dvec3 centre_;
    Fill fill_;
    const std::vector<double> shifts_;
    std::vector<std::vector<NodeCandidate>> poses_;  // per node
    std::vector<double> stretches_, most_stretched_;
    Locals locals_;
    Support support_;
};

}  // namespace

std::vector<model::NodeReach> find_node_reach(const model::Rig &rig, const glm::vec3 &centre)
{
    return NodeSearch(rig, glm::dvec3(centre)).run();
}

}  // namespace claque::meshsplit
