// Turns head, neck and torso about the vertical, on a pose that is evaluated already: people look where they will go
// before they turn, and pull a shoulder back from others that they pass. A function of the pose and the target alone.
#pragma once

#include "lib/math/simd.h"
#include "lib/model/template.h"

namespace claque::pose
{

// The nodes that turn. Each may be missing; what is there is below the one before it.
struct Upper {
    explicit Upper(std::pmr::memory_resource *memory = std::pmr::get_default_resource())
        : torso_nodes(memory), neck_nodes(memory), head_nodes(memory)
    {
    }
    uint32_t torso = model::none, neck = model::none, head = model::none;
    model::Array<uint32_t> torso_nodes, neck_nodes, head_nodes;  // each with all nodes below it
    // Of the sphere that holds every pose: what turns stays within `room` of where the clips have it, as seen from
    // there. Model units.
    float centre_x = 0, centre_z = 0, room = 0;
};

struct UpperTarget {
    const Upper *upper = nullptr;  // null: nothing turns
    float gaze_rad = 0;            // of the head against the body, positive to the left
    float torso_rad = 0;           // of the torso against the hips
};

constexpr float neck_share = 0.4f;  // of the turn of a head that has a neck

// `globals`: [node_count] in model space, changed in place. `active`: [node_count] or null, as of model::Level.
void turn_upper(const UpperTarget &target, const uint8_t *active, math::Columns *globals) noexcept;

}  // namespace claque::pose
