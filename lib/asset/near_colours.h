// Colour ranges of zones whose files and hosts give none: near the colours of the file, and human where they are skin
// and hair, unless others are asked for. This policy has no other place. S2 5.
#pragma once

#include <cstdint>
#include <vector>

#include "lib/model/model.h"

namespace claque::asset
{

// The zones that are those of materials: no image has keys of theirs.
std::vector<bool> material_zones(const model::Model &model);

// Leaves the zone its colour alone as a range.
void keep_colour(model::Zone &zone);

enum class Colours : uint8_t { near = 0, wild = 1, own = 2 };  // clq_colours

// Gives ranges to the zones that `open` names. Wild zones keep the ranges of zone_ranges.h. Own ones get their colour
// alone. Near skins become one zone, so that face and hands always have one colour; two skins of two colours or keys
// keep them. The model has to have passed its check.
void give_ranges(model::Model &model, std::vector<bool> open, Colours colours);

}  // namespace claque::asset
