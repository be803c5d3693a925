// How an individual gets its colours (S1 3, S2 2.1, SPEC 3). All three give the same RGB and depth.
#pragma once

#include "passes/canvas.h"

namespace claque::passes
{

// The papers: every clean bin under its zone's glColor, then all dirty triangles once per zone of their texture,
// ascending, each pass letting through the texels whose key is at least that zone's.
void draw_per_zone(Canvas &canvas, const Individual &individual);

// The same, but a dirty triangle takes part only in the passes of the zones that it touches.
void draw_binned(Canvas &canvas, const Individual &individual);

// One draw a surface: dirty triangles stand once per zone touched in the index list, ascending, and the alpha of their
// vertices scales the texel's key so that one fixed alpha test stands for all of them.
void draw_fused(Canvas &canvas, const Individual &individual);

// Shared by the first two: a surface's clean bins, each under its zone's colour.
void draw_clean(Canvas &canvas, const Individual &individual, uint32_t surface_index);

// The one that the template was prepared for.
void draw_parts(Canvas &canvas, const Individual &individual);

}  // namespace claque::passes
