// The points that degrees of freedom move, for each palette entry. A vertex of several entries lies between the
// positions to which each alone would move it, so it belongs to each of their sets.
#pragma once

#include "lib/model/template.h"
#include "meshsplit/reach_poses.h"
#include "meshsplit/reach_support.h"

namespace claque::meshsplit
{

// Returns, per node, whether it or an ancestor has a degree of freedom of its transform.
std::vector<uint8_t> free_nodes(const model::Rig &rig);

// Points fixed to one node, in its frame, and their morph deltas.
class PointSet
{
public:
    // What the degrees of freedom of morph targets can add to each weight.
    struct Range {
        double low = 0, high = 0;
    };
    using Ranges = std::vector<Range>;

    PointSet(uint32_t node, const model::PaletteEntry &entry) : node_(node), bind_(entry.inverse_bind) {}
    void add(glm::vec3 bind_position);
    void add_delta(uint32_t weight, const float *delta);  // to the last added point
    void close(const Ranges &ranges);

    uint32_t node() const { return node_; }
    bool empty() const { return points_.empty(); }
    bool morphs() const { return !deltas_.empty(); }
    // Returns the distance from the node's origin and the motion caused by changing weights.
    MotionBound motion_bound(const float *weights_from, const float *weights_to, const PoseSegment &segment) const;
    const glm::dvec3 &centre() const { return centre_; }
    // Radius round centre().
    double radius(const float *weights) const { return radius_ + morphed(weights); }
    void support(const Directions &directions, const Ranges &ranges, const float *weights, Support &out) const;

private:
    struct Delta {
        uint32_t point, weight;
        glm::dvec3 move;
    };
    struct Longest {
        uint32_t weight;
        double length = 0, freely = 0;  // of the deltas; the largest weight that degrees of freedom add
    };
    double morphed(const float *weights) const;

    uint32_t node_;
    math::Affine bind_;
    std::vector<glm::dvec3> points_;
    std::vector<Delta> deltas_;  // by point
    std::vector<Longest> longest_;
    glm::dvec3 centre_ = glm::dvec3(0);
    double radius_ = 0;
};

// The vertices of all levels: those that some degree of freedom moves, as point sets, and the others.
struct FreePointSets {
    explicit FreePointSets(const model::Template &tmpl);

    std::vector<PointSet> point_sets;         // without empty ones
    std::vector<std::vector<uint8_t>> moved;  // per level and source vertex
    PointSet::Ranges ranges;                  // per weight

private:
    void find_ranges(const model::Rig &rig);
    void find_moved(const model::Level &level, const model::Rig &rig);
};

}  // namespace claque::meshsplit
