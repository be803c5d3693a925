// The atlas of the dragon: one cell for each zone. The cell's colours are the zone's light and dark, its alpha the
// zone key.
#pragma once

#include <claque/template.h>

#include <vector>

#include "samples/scenes/hundred/piece_mesh.h"

namespace scenes::hundred
{

constexpr uint32_t atlas_cells_wide = 4, atlas_cells_high = 2, cell_px = 64;

// A point of a cell, u and v [0, 1], with a margin to its neighbours.
void in_cell(Cell cell, double u, double v, float (&out)[2]);

std::vector<uint8_t> atlas();

struct ZonePaint {
    const char *name;
    float colour[3];
    clq_hsb_range range;
};
const ZonePaint &zone_paint(Cell cell);
uint32_t key_of(Cell cell);

// The colours of one house's dragons in the procession: a range for each cell.
constexpr uint32_t house_count = 6;
std::vector<clq_hsb_range> palette_of(uint32_t house);

}  // namespace scenes::hundred
