// How several processes divide the frames of a film, and the memory that they need for it.
#pragma once

#include "samples/cli/render_work.h"

namespace cli
{

// Whole frames take the least time together, tiles take the least time for each frame.
enum class Division { frames, tiles };
Division division_of(const RenderArguments &arguments);

// The bytes that one frame may need, or one picture that is drawn in tiles.
size_t place_bytes(const RenderArguments &arguments);
// How many of these places there are. Frames: one for each task that a worker may have. Tiles: two pictures in turn.
size_t place_count(const RenderArguments &arguments, uint32_t workers, uint32_t tasks_each);

}  // namespace cli
