// Adds zones to characters whose files define none, so that their individuals can be coloured too: one zone for each
// material name and base colour.
#pragma once

#include "lib/model/model.h"

namespace claque::asset
{

// Gives a zone of model.zones to each used material (by index) whose image has no zone keys. Materials of equal name
// and colour share a zone. Keyed zones come first in the list, because images refer to them by key.
void add_material_zones(const std::vector<bool> &used, model::Model &model);

}  // namespace claque::asset
