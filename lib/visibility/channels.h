// What each pixel of a visibility picture shows, from the triangle's number and its vertices.
#pragma once

#include "lib/visibility/picture.h"

namespace claque::visibility
{

// Writes the arrays of `out` that are not null. All numbers are less than Numbers::count(), and the vertices of all
// individuals in the picture are there.
void write_channels(const Picture &picture, double metres_per_unit, const base::Jobs &jobs,
                    const clq_pixel_channels &out);

}  // namespace claque::visibility
