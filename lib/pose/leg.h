// The two-bone leg mechanism: puts a foot where a track wants it. It turns thigh and shin about hip and knee in the
// plane in which they are bent, so that no length changes, and it works on a pose that is evaluated already. A
// function of the pose and the target alone.
#pragma once

#include "lib/base/span.h"
#include "lib/math/simd.h"
#include "lib/model/template.h"

namespace claque::pose
{

// The nodes of one leg, and the points of the foot that touch the ground.
struct Leg {
    explicit Leg(std::pmr::memory_resource *memory = std::pmr::get_default_resource())
        : thigh_nodes(memory), shin_nodes(memory), foot_nodes(memory)
    {
    }
    uint32_t thigh = model::none, shin = model::none, foot = model::none;
    // The nodes that move with each segment, the segment's own node first.
    model::Array<uint32_t> thigh_nodes, shin_nodes, foot_nodes;
    // Of the shin's end, in the frame of `shin`: rigs made for inverse kinematics hang their feet on the root.
    glm::vec3 ankle = glm::vec3(0);
    glm::vec3 ball = glm::vec3(0), heel = glm::vec3(0);  // in the frame of `foot`
    float max_shift = 0;                                 // model units: how far a foot may be moved
};

// Where a foot has to be, in model space.
struct FootTarget {
    const Leg *leg = nullptr;
    bool planted = false;
    float x = 0, z = 0;  // planted: of the sole (sole_of); otherwise how far that is moved
    float turn_rad = 0;  // of the foot about y
    float weight = 1;    // [0, 1] of all of this
    float ground = 0;    // [0, 1] how far the lower of ball and heel is moved to y = 0
    // Of the ground below a planted foot; in the air how far the foot is moved up. At 0 the ground is level.
    float y = 0;
    float sink = 0;  // by which the whole body has been lowered (PoseJob::run); of both feet the same
};

// The nodes below `node` with it, without those below `end` (none: all), ascending except for `node` itself, which
// is first.
model::Array<uint32_t> nodes_below(const model::Rig &rig, uint32_t node, uint32_t end,
                                   std::pmr::memory_resource *memory);

// `globals`: [node_count] in model space, changed in place.
void move_foot(const FootTarget &target, math::Columns *globals) noexcept;

// Where a foot is: where the ball of the foot would lie if the foot stood flat. A foot whose toes are up rolls over its
// heel, which then stays, and the ball comes forward as it sinks.
glm::vec3 sole_of(const glm::vec3 &ball, const glm::vec3 &heel) noexcept;

// A point of a node's frame in model space.
glm::vec3 point_of(const math::Columns &node, const glm::vec3 &point) noexcept;

}  // namespace claque::pose
