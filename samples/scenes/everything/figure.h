// The figure of `everything` as a template, made through the C API from arrays. It has what characters seldom have all
// at once: eight influences a vertex, colours of vertices, two morph targets, joints that stretch and one that mirrors,
// rigid parts, a double-sided cape with holes, and two texture sets.
#pragma once

#include "samples/scenes/library.h"

namespace scenes::everything
{

constexpr double figure_height_m = 1.9;

// Lives as long as the library.
clq_template *figure_of(Library &library);

}  // namespace scenes::everything
