// How scenes draw what is too far away to have a place, such as a sky.
#pragma once

#include "samples/scenes/eye.h"
#include "samples/scenes/gl.h"

namespace scenes
{

// From now on GL draws round the eye, without light or textures, and only where nothing is yet: it takes no depth from
// what is drawn later. 1 is `metres` away, which has to lie between the planes of the projection.
void begin_distance(const Gl &gl, const Eye &eye, float metres);
// Back to the scene's coordinates, with lighting and depth on.
void end_distance(const Gl &gl, const Eye &eye);

}  // namespace scenes
