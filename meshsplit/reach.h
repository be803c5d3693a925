// What the degrees of freedom of a rig (S0 3) mean for the Sklsroot Bsphere (S0 4.1): how far they and the clips together
// can bring a vertex, proved for all their combinations, not sampled.
//
// Per pose of the clips, sets of points are carried from the leaves of the skeleton to the root as support functions
// (reach_support.h). Which poses need that is found best first: balls bound all of them, only those that stand out are
// looked at more closely, and what is left is below what was found.
#pragma once

#include "meshsplit/reach_solver.h"

namespace claque::meshsplit
{

class FreeReach
{
public:
    explicit FreeReach(const model::Template &tmpl);

    // Per level and source vertex: whether any degree of freedom moves it. Only these are meant below.
    const std::vector<std::vector<uint8_t>> &moved() const { return free_.moved; }
    const std::vector<PoseAt> &poses() const { return poses_; }
    // About where the smallest sphere has its centre that holds these vertices and some points besides.
    glm::dvec3 centre(const std::vector<glm::dvec3> &points);
    // No such vertex is ever farther from `centre`. `reached`: a distance that some vertex is known to reach.
    double radius(const glm::dvec3 &centre, double reached);

private:
    void look_at(uint32_t pose);
    double bound_by(const Resolution &resolution, std::vector<Support> &own, const ReachSolver::Cutoff &cutoff);
    void own_supports(const Resolution &resolution, std::vector<Support> &own) const;
    void find_poses();
    void propagate(uint32_t pose, double bound, std::vector<double> &bounds) const;

    const model::Template &tmpl_;
    FreePointSets free_;
    std::vector<PoseAt> poses_;
    std::vector<double> bulges_;     // per pose: how far vertices may stray towards its neighbours
    std::vector<double> distances_;  // per pose: how far vertices may go since the one before; infinity after a jump
    LocalPoser poser_;
    Locals locals_;
    ReachSolver solver_;
    Resolution coarse_, fine_;
    std::vector<Support> own_coarse_, own_fine_;  // per body; those with morph targets as in the last pose
    Support all_;
};

// Template::node_reach: per node the most that its origin is away from `centre` in all poses that the Sklsroot Bsphere
// holds, and the most that lengths in its frame are stretched.
std::vector<model::NodeReach> find_node_reach(const model::Rig &rig, const glm::vec3 &centre);

}  // namespace claque::meshsplit
