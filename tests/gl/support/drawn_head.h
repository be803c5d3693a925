// A head with a drawn face, as textured characters of files have one: four charts whose borders run through the face,
// and texture coordinates that are no linear function of the place.
#pragma once

#include "lib/model/model.h"

namespace gltest
{

// 0.24 m high round the origin, facing +z.
claque::model::Model drawn_head();

}  // namespace gltest
