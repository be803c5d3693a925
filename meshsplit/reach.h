// Bounds the effect of a rig's degrees of freedom (S0 3) on the Sklsroot Bsphere (S0 4.1): how far they and the clips
// together can move a vertex. The bound is proved for all combinations, not sampled.
//
// For each pose of the clips, point sets are propagated from the leaves of the skeleton to the root as support
// functions (reach_support.h). A best-first search selects the poses: balls bound all of them, and only the largest are
// bounded more precisely, until all others are below the result.
#pragma once

#include "meshsplit/reach_solver.h"

namespace claque::meshsplit
{

class FreeReach
{
public:
    // There are no poses afterwards if there would be more than `most`.
    explicit FreeReach(const model::Template &tmpl, uint64_t maximum = ~0ull);

    // Per level and source vertex: whether any degree of freedom moves it. The functions below consider only these.
    const std::vector<std::vector<uint8_t>> &moved() const { return free_.moved; }
    const std::vector<PoseAt> &poses() const { return poses_; }
    // Returns about the centre of the smallest sphere that holds these vertices and some further points.
    glm::dvec3 centre(const std::vector<glm::dvec3> &points);
    // Returns a bound of the distance of these vertices from `centre`. `reached`: a distance that some vertex is known
    // to reach. After `precise` precise evaluations the bound found so far is returned.
    double radius(const glm::dvec3 &centre, double reached, uint64_t precise = ~0ull);

private:
    void look_at(uint32_t pose);
    double bound_by(const Resolution &resolution, std::vector<Support> &own, const ReachSolver::Cutoff &cutoff);
    void own_supports(const Resolution &resolution, std::vector<Support> &own) const;
    bool find_poses(uint64_t maximum);
    void propagate(uint32_t pose, double bound, std::vector<double> &bounds) const;

    const model::Template &tmpl_;
    FreePointSets free_;
    std::vector<PoseAt> poses_;
    std::vector<double> bulges_;     // per pose: how far vertices may deviate on the way to its neighbours
    std::vector<double> distances_;  // per pose: how far vertices may move from the pose before; infinity after a jump
    LocalPoser poser_;
    Locals locals_;
    ReachSolver solver_;
    Resolution coarse_, fine_;
    std::vector<Support> own_coarse_, own_fine_;  // per point set; those with morph targets are of the last pose
    Support all_;
};

// Returns Template::node_reach: for each node, bounds of its origin's distance from `centre` and of its frame's
// stretch, in all poses that the Sklsroot Bsphere holds; nothing if these are more than `most`.
std::vector<model::NodeReach> find_node_reach(const model::Rig &rig, const glm::vec3 &centre, uint64_t maximum = ~0ull);

}  // namespace claque::meshsplit
