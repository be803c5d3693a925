// The buildings on and round the plaza, and its ground.
#pragma once

#include "samples/scenes/parts.h"
#include "samples/scenes/plaza_layout.h"

namespace scenes
{

// The paving, with broad stains in its colours; texture coordinates count repeats of the flagstones.
void pave(Geometry &ground, const PlazaLayout &layout, uint64_t seed);

// The surrounding country, visible between and beyond buildings.
void grow(Geometry &field, const PlazaLayout &layout, uint64_t seed);

// Colonnades on three sides, a temple at the back, cypresses behind it, a fountain and the speaker's platform.
void build(Parts &stone, const PlazaLayout &layout, uint64_t seed);

}  // namespace scenes
