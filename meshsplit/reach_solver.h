// All places to which the degrees of freedom can bring a set of bodies in one pose, bounded in two ways: by balls, at
// next to no cost, and by support functions, as tight as the directions are fine.
//
// A station is a node with degrees of freedom of its transform. Everything between two stations stands still in a pose,
// so bodies and stations are carried to the next station above in one step, or to model space where there is none.
#pragma once

#include "meshsplit/reach_point_sets.h"

namespace claque::meshsplit
{

// How finely sets are looked at: directions, and what they ask of each degree of freedom.
struct Resolution {
    Resolution(int splits, const model::Rig &rig);
    Directions directions;
    std::vector<DofSweep> sweeps;  // one for each of the rig's, empty ones for morph targets
};

class ReachSolver
{
public:
    explicit ReachSolver(const model::Rig &rig);

    void set_pose(const Locals &locals);  // the pose that everything below is about
    // The distance from `centre`, in model space, of whatever a body brings along.
    double ball(const std::vector<PointSet> &point_sets, const float *weights, const glm::dvec3 &centre);

    // What supports may leave out: bodies that stay as close as this.
    struct Cutoff {
        glm::dvec3 centre;
        double distance;
    };
    // Of all bodies in model space, whose own supports are given one each. To follow ball() of the same. Bodies that
    // cannot get farther than is enough are left out; the most that any of these may is returned.
    double support(const Resolution &resolution, const std::vector<PointSet> &point_sets, const float *weights,
                   const std::vector<Support> &own, const Cutoff &cutoff, Support &out);

    // The same two for a node's origin.
    double origin_ball(uint32_t node, const glm::dvec3 &centre) const;
    void origin_support(const Resolution &resolution, uint32_t node, Support &out);

    bool is_free(uint32_t node) const { return joint_of_[node] != model::none; }

private:
    struct FreeJoint {
        uint32_t node = 0;
        uint32_t above = model::none;  // station
        double shift = 0;              // most that its degrees of freedom shift by
        std::vector<uint32_t> dofs;    // as they act on a point: last of the list first
        AffineMap lift;                // to the frame of the station above
        double lift_stretch = 1;
    };
    double ball_of(uint32_t node, const glm::dvec3 &p, double radius, const glm::dvec3 &centre) const;
    void sweep(const Resolution &resolution, const FreeJoint &joint, double reach, Support &set);

    const model::Rig &rig_;
    std::vector<FreeJoint> joints_;    // parents before children
    std::vector<uint32_t> joint_of_;   // per node: the nearest at or above it
    std::vector<AffineMap> to_joint_;  // per node: from its frame to that of its station, before the station's freedoms
    std::vector<double> stretch_;      // of to_station_
    std::vector<double> reach_;        // per station, found by ball()
    std::vector<uint8_t> reached_;     // per station: whether its set is not empty
    std::vector<Support> sets_;        // per station
    Support scratch_;
};

}  // namespace claque::meshsplit
