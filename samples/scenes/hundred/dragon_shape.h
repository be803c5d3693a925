// The forms of the dragon, a rigid piece for each Skeleton node, at three finenesses.
#pragma once

#include "samples/scenes/hundred/clay.h"
#include "samples/scenes/hundred/dragon_plan.h"

namespace scenes::hundred
{

enum class Fineness { fine, middle, coarse };

// What hangs on a node, in model space at rest.
Clay piece_of(uint32_t node, Fineness fineness);

// The two that are long: dragon_limbs.cpp and dragon_head.cpp.
void add_leg_piece(Clay &clay, uint32_t node, Fineness fineness);
void add_head_piece(Clay &clay, uint32_t node, Fineness fineness);  // of head to ear_r

Point joint(uint32_t node);

}  // namespace scenes::hundred
