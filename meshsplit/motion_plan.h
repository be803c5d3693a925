// Selects the joints of a rig's motion and the other animated numbers, and appends the rows of clips.
#pragma once

#include <vector>

#include "lib/model/motion.h"

namespace claque::meshsplit
{

// Fills nodes and groups. Joints that remain active longest come first, so that levels need only the first blocks.
void plan_joints(const model::Rig &rig, model::Motion &out);

// What append_clip holds at most for one clip, and what it adds to `out` in any case.
uint64_t clip_bytes(const model::Rig &rig, uint32_t intervals, const model::Motion &out);
uint64_t place_bytes(const model::Motion &out);

// Appends one clip at one rate: its blocks, rows and kept channels. `kept`: [channel_count], 1 for channels that are
// kept. intervals 0: one row, for clips whose channels are all kept or that have no length.
void append_clip(const model::Rig &rig, uint32_t clip, uint32_t intervals, const std::vector<uint8_t> &kept,
                 model::Motion &out);

}  // namespace claque::meshsplit
