// Which nodes of a rig are joints of its motion, which other numbers move, and the rows of one clip at one rate.
#pragma once

#include "lib/model/motion.h"

#include <vector>

namespace claque::meshsplit
{

// Fills nodes and groups. Joints that stay evaluated longest stand first, so that levels need the first blocks only.
void plan_joints(const model::Rig &rig, model::Motion &out);

// Appends one clip at a rate: its places, rows and what it keeps. kept: [channel_count], 1 where a channel is kept.
// intervals 0: one row, for clips whose channels are all kept or of no length.
void append_clip(const model::Rig &rig, uint32_t clip, uint32_t intervals, const std::vector<uint8_t> &kept,
                 model::Motion &out);

}  // namespace claque::meshsplit
