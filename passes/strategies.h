// The draw strategies (S1 3, S2 2.1). All three give the same RGB and depth.
#pragma once

#include "passes/canvas.h"

namespace claque::passes
{

// As in the papers: every clean bin under its zone's glColor, then all dirty triangles once per zone of their texture,
// ascending. Each pass lets the texels pass whose key is at least that of its zone.
void draw_per_zone(Canvas &canvas, const Individual &individual);

// The same, but a dirty triangle is drawn only in the passes of the zones that it touches.
void draw_binned(Canvas &canvas, const Individual &individual);

// One draw per surface. Dirty triangles are in the index list once per zone they touch, ascending; the alpha of their
// vertices scales the texel's key so that one fixed alpha test serves all zones.
void draw_fused(Canvas &canvas, const Individual &individual);

// Draws a surface's clean bins, each under its zone's colour. Shared by the first two.
void draw_clean(Canvas &canvas, const Individual &individual, uint32_t surface_index);

// Whatever the strategy: one draw per surface with the individual's own texture, which has the colours of its zones.
void draw_close(Canvas &canvas, const Individual &individual);

// One draw per surface for an individual whose zones all have one colour, so that no texel needs a test. In place of
// the fused and binned strategies; per-zone stays the papers' way.
void draw_plain(Canvas &canvas, const Individual &individual);

// Draws with the strategy for which the template was prepared.
void draw_parts(Canvas &canvas, const Individual &individual);

}  // namespace claque::passes
