// The distance from which close textures are no longer worth their memory.
#pragma once

#include "passes/prepared.h"

namespace claque::passes
{

// The mean difference, [0, 255] of a channel, between an individual's filtered texture and GL_NEAREST, over the pixels
// of a level seen from `distance_m`: at rest, in full light and the template's own colours, from several sides, in a
// picture of 768 lines over 60 degrees. Nothing hides anything. Throws std::bad_alloc.
float close_difference(const PreparedTemplate &prepared, uint32_t level, float distance_m);

// The distance at which an individual that comes nearer changes least: the farthest at which that difference is 2 of
// 255, or the one at which it is smallest if it is larger everywhere. Farther away GL_NEAREST leaves out more and more
// texels, and the two differ ever more. 0 if the level nearest to the eye can show none. Throws std::bad_alloc.
float close_distance(const PreparedTemplate &prepared);

}  // namespace claque::passes
