// The atlas of the dragon: one cell a zone; its colours are the light and dark on it, its alpha the zone's key.
#pragma once

#include "samples/scenes/hundred/piece_mesh.h"

#include <claque/template.h>

#include <vector>

namespace scenes::hundred
{

constexpr uint32_t atlas_cells_wide = 4, atlas_cells_high = 2, cell_px = 64;

// A point of a cell, u and v [0, 1], away from its neighbours.
void in_cell(Cell cell, double u, double v, float (&out)[2]);

std::vector<uint8_t> atlas();

struct ZonePaint {
    const char *name;
    float colour[3];
    clq_hsb_range range;
};
const ZonePaint &zone_paint(Cell cell);
uint32_t key_of(Cell cell);

// How one of the houses that walk in the procession dyes its dragons: a range for each cell.
constexpr uint32_t house_count = 6;
std::vector<clq_hsb_range> palette_of(uint32_t house);

}  // namespace scenes::hundred
