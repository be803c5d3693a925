// The poses at which a rig's clips are looked at, with its degrees of freedom left out (at zero), and how far what moves
// with a node can stray from straight ways between two of them.
#pragma once

#include "lib/pose/pose.h"

#include <functional>

namespace claque::meshsplit
{

struct PoseAt {
    uint32_t clip = model::none;
    double time_s = 0;
};

// The rest pose, then every clip at its sample_times(), clip by clip.
std::vector<PoseAt> poses_of(const model::Rig &rig);

// Whether the actor moves from this pose to the next, rather than jumps.
bool is_continuous(const std::vector<PoseAt> &poses, size_t i);

// Local transforms and morph weights of one pose.
struct Locals {
    std::vector<math::Trs> nodes;
    std::vector<float> weights;
};

class LocalPoser
{
public:
    explicit LocalPoser(const model::Rig &rig);
    void pose(const PoseAt &at, Locals &out);

private:
    const model::Rig *rig_;
    std::vector<float> dofs_;
    std::vector<math::Columns> globals_;
    std::vector<math::Affine> palette_;
};

// Upper bounds for a set of points while the pose goes from one to another, seen from the frame of some node: distance
// from its origin, and the first and second derivative of position by the way (0 to 1). Between its places at the ends a
// point is off the straight line by an eighth of the second derivative at most.
struct MotionBound {
    double reach = 0, speed = 0, acceleration = 0;

    double chord_deviation() const { return acceleration / 8; }
    void merge(const MotionBound &other);
};

// What a node's own motion between two poses adds. Translation, rotation and scale may follow curves: `bend` is the most
// that the second derivative of each is.
struct NodeMotionBound {
    double scale = 1, growth = 0, scale_acceleration = 0;    // largest factor, largest change of a factor
    double turn = 0, turn_acceleration = 0;                  // radians
    double offset = 0, travel = 0, travel_acceleration = 0;  // distance from its parent's origin, change of place

    NodeMotionBound() = default;
    // Along straight lines and arcs of constant speed.
    NodeMotionBound(const math::Trs &from, const math::Trs &to);
    // On cubic splines, given a third and two thirds of the way too.
    explicit NodeMotionBound(const math::Trs *const (&thirds)[4]);
    // `inner` in the node's own frame; the result in its parent's.
    MotionBound of(const MotionBound &inner, double max_shift) const;
};

// From one pose to the next.
struct PoseSegment {
    std::vector<NodeMotionBound> nodes;
    std::vector<double> weights,
        weight_accelerations;  // of morph targets: how fast they change, and second derivatives
};

// Per node, how far its translational degrees of freedom can shift what hangs on it.
std::vector<double> max_shifts(const model::Rig &rig);

// Every pose of poses_of(), and poses between where much happens. `visit` is told what happens since the pose
// before, null where the actor jumps from that one to this.
using Visit = std::function<void(const PoseAt &, const Locals &, const PoseSegment *since)>;
void walk_poses(const model::Rig &rig, const Visit &visit);

}  // namespace claque::meshsplit
