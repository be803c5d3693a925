// The two-bone leg mechanism: puts a foot where a track wants it. It turns thigh and shin about hip and knee in the
// plane in which they are bent, so that no length changes, and it works on a pose that is evaluated already. A
// function of the pose and the target alone.
#pragma once

#include <cmath>

#include "lib/base/span.h"
#include "lib/math/simd.h"
#include "lib/model/template.h"

namespace claque::pose
{

// A point of a sole that is the lowest one in some pose of its foot.
struct SolePoint {
    glm::vec3 at = glm::vec3(0);  // in the frame of the foot, or of its toes
    // Where it touches the ground, as seen from the ball of a foot that stands flat and points along x. A sole that
    // rolls over its points puts each of them there.
    float ahead = 0, aside = 0;
};

// The nodes of one leg, and the points of the foot that touch the ground.
struct Leg {
    explicit Leg(std::pmr::memory_resource *memory = std::pmr::get_default_resource())
        : thigh_nodes(memory), shin_nodes(memory), foot_nodes(memory), sole(memory)
    {
    }
    uint32_t thigh = model::none, shin = model::none, foot = model::none;
    // The nodes that move with each segment, the segment's own node first.
    model::Array<uint32_t> thigh_nodes, shin_nodes, foot_nodes;
    // Of the shin's end, in the frame of `shin`: rigs made for inverse kinematics hang their feet on the root.
    glm::vec3 ankle = glm::vec3(0);
    glm::vec3 ball = glm::vec3(0), heel = glm::vec3(0);  // in the frame of `foot`
    uint32_t toes = model::none;
    model::Array<SolePoint> sole;  // those of the foot, then those of the toes; never empty
    uint32_t first_of_toes = 0;
    float max_shift = 0;  // model units: how far a foot may be moved
};

// Where a foot has to be, in model space.
struct FootTarget {
    const Leg *leg = nullptr;
    bool planted = false;
    float x = 0, z = 0;    // planted: of the sole (print_of); otherwise how far that is moved
    float turn_rad = NAN;  // to which the foot points, about y from +z; NaN: as in the pose
    float weight = 1;      // [0, 1] of all of this
    float ground = 0;      // [0, 1] how far the lowest point of the sole is moved to y = 0
    float clear =
        -HUGE_VALF;  // the height below which that point does not come, as far as it is not moved to the ground
    // Of the ground below a planted foot; in the air how far the foot is moved up. At 0 the ground is level.
    float y = 0;
    float slope = 0;  // of that ground, in the direction of the foot: how much it rises in one unit
    float sink = 0;   // by which the whole body has been lowered (PoseJob::run); of both feet the same
};

// The nodes below `node` with it, without those below `end` (none: all), ascending except for `node` itself, which
// is first.
model::Array<uint32_t> nodes_below(const model::Rig &rig, uint32_t node, uint32_t end,
                                   std::pmr::memory_resource *memory);

// `globals`: [node_count] in model space, changed in place.
void move_foot(const FootTarget &target, math::Columns *globals) noexcept;

// A foot over the ground.
struct Print {
    float x = 0, z = 0;              // where its ball would lie if the foot rolled until it stood flat
    float low = 0;                   // height of the lowest point of the sole
    float ahead_x = 0, ahead_z = 1;  // unit vector: to which the foot points
};
Print print_of(const Leg &leg, const math::Columns *globals) noexcept;

// A point of a node's frame in model space.
glm::vec3 point_of(const math::Columns &node, const glm::vec3 &point) noexcept;

}  // namespace claque::pose
