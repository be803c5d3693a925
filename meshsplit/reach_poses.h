// Samples the poses of a rig's clips with all degrees of freedom at zero, and bounds how far points fixed to a node
// deviate from straight lines between two poses.
#pragma once

#include <functional>

#include "lib/pose/pose.h"

namespace claque::meshsplit
{

struct PoseAt {
    uint32_t clip = model::none;
    double time_s = 0;
};

// Returns the rest pose, then every clip at its sample_times(), clip by clip.
std::vector<PoseAt> poses_of(const model::Rig &rig);

// Returns whether the actor moves continuously from this pose to the next.
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

// Bounds for a set of points between two poses, in the frame of some node: distance from its origin, and the first and
// second derivative of position by the parameter (0 to 1). A point deviates from the straight line between its end
// positions by at most an eighth of the second derivative.
struct MotionBound {
    double reach = 0, speed = 0, acceleration = 0;

    double chord_deviation() const { return acceleration / 8; }
    void merge(const MotionBound &other);
};

// The motion that a node itself adds between two poses. Translation, rotation and scale may follow curves; the
// acceleration members bound their second derivatives.
struct NodeMotionBound {
    // Largest scale, and largest change of scale.
    double scale = 1, growth = 0, scale_acceleration = 0;
    double turn = 0, turn_acceleration = 0;  // radians

    // Distance from its parent's origin, and change of position.
    double offset = 0, travel = 0, travel_acceleration = 0;

    NodeMotionBound() = default;
    // Along straight lines and arcs of constant speed.
    NodeMotionBound(const math::Trs &from, const math::Trs &to);
    // On cubic splines, from the transforms at 0, 1/3, 2/3 and 1.
    explicit NodeMotionBound(const math::Trs *const (&thirds)[4]);
    // `inner` is in the node's own frame; the result is in its parent's.
    MotionBound of(const MotionBound &inner, double max_shift) const;
};

// NodeMotionBound::of for a node and all those above it, in one step: its result is linear in `inner`. Maps are made
// from the roots downwards, so that a bound in model space takes a step for each node, however deep it is.
class MotionMap
{
public:
    MotionMap() = default;  // of model space
    MotionMap(const MotionMap &above, const NodeMotionBound &node, double max_shift);

    MotionBound of(const MotionBound &inner) const;
    MotionBound origin() const { return origin_; }  // of a point at the node's origin

private:
    // What each of `inner` adds to each of the result. A reach scales as a speed and an acceleration do.
    double scale_ = 1, reach_to_speed_ = 0, reach_to_acceleration_ = 0, speed_to_acceleration_ = 0;
    MotionBound origin_;
};

// The motion from one pose to the next.
struct PoseSegment {
    std::vector<NodeMotionBound> nodes;
    // Of morph targets: first and second derivatives of the weights.
    std::vector<double> weights, weight_accelerations;
};

// Returns, per node, how far its translational degrees of freedom can shift what it moves.
std::vector<double> max_shifts(const model::Rig &rig);

// Visits every pose of poses_of(), and poses between where the motion is large. `since` is the motion from the pose
// before, null if the actor jumps to this pose.
using Visit = std::function<void(const PoseAt &, const Locals &, const PoseSegment *since)>;
// Returns false, and stops, if that would be more than `most` poses.
bool walk_poses(const model::Rig &rig, const Visit &visit, uint64_t maximum = ~0ull);

}  // namespace claque::meshsplit
