// The forms of the dragon, a rigid piece for each Skeleton node, at three finenesses.
#pragma once

#include "samples/scenes/hundred/dragon_plan.h"
#include "samples/scenes/hundred/piece_mesh.h"

namespace scenes::hundred
{

enum class Detail { fine, middle, coarse };

// What hangs on a node, in model space at rest.
PieceMesh piece_of(uint32_t node, Detail detail);

// The two that are long: dragon_limbs.cpp and dragon_head.cpp.
void add_leg_piece(PieceMesh &mesh, uint32_t node, Detail detail);
void add_head_piece(PieceMesh &mesh, uint32_t node, Detail detail);  // of head to ear_r

Point joint(uint32_t node);

}  // namespace scenes::hundred
