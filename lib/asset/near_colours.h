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

enum class Colours : uint8_t { near = 0, wild = 1, own = 2 };  // clq_colours

// Gives ranges to the zones that `open` names; wild ones keep those of zone_ranges.h. Of near ones, what shows skin
// becomes one zone, so that face and hands always have one colour; where that cannot be, because two skins have two
// colours or keys, their colours stay. The model has to have passed its check.
void give_ranges(model::Model &model, std::vector<bool> open, Colours colours);

}  // namespace claque::asset
