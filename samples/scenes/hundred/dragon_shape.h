// The shapes of the dragon, a rigid piece for each Skeleton node, at three resolutions.
#pragma once

#include "samples/scenes/hundred/dragon_plan.h"
#include "samples/scenes/hundred/piece_mesh.h"

namespace scenes::hundred
{

enum class Detail { fine, middle, coarse };

// A node's piece, in model space at rest.
PieceMesh piece_of(uint32_t node, Detail detail);

// The two long ones, in dragon_limbs.cpp and dragon_head.cpp.
void add_leg_piece(PieceMesh &mesh, uint32_t node, Detail detail);
void add_head_piece(PieceMesh &mesh, uint32_t node, Detail detail);  // for nodes head to ear_r

Point joint(uint32_t node);

}  // namespace scenes::hundred
