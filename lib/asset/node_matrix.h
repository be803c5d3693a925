// A node's matrix taken apart: the rig keeps translation, rotation and scale, because clips move those.
#pragma once

#include "lib/math/affine.h"

namespace claque::asset
{

struct DecomposedMatrix {
    math::Trs trs;
    // Largest difference of an axis put together again to the one given, as a share of the longest axis. Of a matrix
    // that shears it is large; of rounded ones about 1e-7.
    double error = 0;
};

// `matrix` is 16 numbers by column; its last row is the caller's business. A mirrored one gets a negative x scale; an
// axis of no length gets a direction that fits the others.
DecomposedMatrix decompose(const float matrix[16]);

}  // namespace claque::asset
