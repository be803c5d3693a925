// Decomposes a node's matrix into translation, rotation and scale, because clips animate those.
#pragma once

#include "lib/math/affine.h"

namespace claque::asset
{

struct DecomposedMatrix {
    math::Trs trs;
    // The largest difference between an axis of the recomposed matrix and the given one, relative to the longest axis.
    // It is large for a matrix with shear and about 1e-7 for a rounded one.
    double error = 0;
};

// `matrix` is 16 numbers by column; its last row is not checked here. A mirroring matrix gets a negative x scale. An
// axis of length 0 gets a direction that fits the others.
DecomposedMatrix decompose(const float matrix[16]);

}  // namespace claque::asset
