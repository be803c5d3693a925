// Bounds all positions to which degrees of freedom can move point sets in one pose, in two ways: by balls, at almost no
// cost, and by support functions, as tight as the directions are fine.
//
// A joint here is a node with degrees of freedom of its transform. Everything between two joints is fixed in a pose. So
// point sets and joints are propagated to the next joint above in one step, or to model space if there is none.
#pragma once

#include "meshsplit/reach_point_sets.h"

namespace claque::meshsplit
{

// The resolution of support functions: directions, and the sweep of each degree of freedom over them.
struct Resolution {
    Resolution(int splits, const model::Rig &rig);
    Directions directions;
    std::vector<DofSweep> sweeps;  // one for each of the rig's degrees of freedom, empty for morph targets
};

class ReachSolver
{
public:
    explicit ReachSolver(const model::Rig &rig);

    void set_pose(const Locals &locals);  // sets the pose that the functions below use

    // Returns a bound of the distance of all point sets from `centre`, in model space.
    double ball(const std::vector<PointSet> &point_sets, const float *weights, const glm::dvec3 &centre);

    // support() may leave out point sets that stay within this distance.
    struct Cutoff {
        glm::dvec3 centre;
        double distance;
    };
    // Computes the support of all point sets in model space; `own` has the support of each. Requires ball() of the same
    // sets. Point sets that stay within the cutoff are left out; returns the largest distance that any of these can
    // reach.
    double support(const Resolution &resolution, const std::vector<PointSet> &point_sets, const float *weights,
                   const std::vector<Support> &own, const Cutoff &cutoff, Support &out);

    // The same two for a node's origin.
    double origin_ball(uint32_t node, const glm::dvec3 &centre) const;
    void origin_support(const Resolution &resolution, uint32_t node, Support &out);

    bool is_free(uint32_t node) const { return joint_of_[node] != model::none; }

private:
    struct FreeJoint {
        uint32_t node = 0;
        uint32_t above = model::none;  // index of the next joint above
        double shift = 0;              // largest shift by its degrees of freedom
        std::vector<uint32_t> dofs;    // in the order in which they act on a point: last of the list first
        AffineMap lift;                // to the frame of the joint above
        double lift_stretch = 1;
    };
    double ball_of(uint32_t node, const glm::dvec3 &p, double radius, const glm::dvec3 &centre) const;
    void sweep(const Resolution &resolution, const FreeJoint &joint, double reach, Support &set);

    const model::Rig &rig_;
    std::vector<FreeJoint> joints_;   // parents before children
    std::vector<uint32_t> joint_of_;  // per node: the nearest joint at or above it

    // Per node: from its frame to that of its joint, before the joint's degrees of freedom
    std::vector<AffineMap> to_joint_;
    std::vector<double> stretch_;   // of to_joint_
    std::vector<double> reach_;     // per joint, set by ball()
    std::vector<uint8_t> reached_;  // per joint: whether its set is not empty
    std::vector<Support> sets_;     // per joint
    Support scratch_;
};

}  // namespace claque::meshsplit
