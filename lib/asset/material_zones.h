// Zones of characters whose files know of none: one for each material's name and base colour, so that these people can
// be coloured too.
#pragma once

#include "lib/model/model.h"

namespace claque::asset
{

// Gives each used material (by index) whose image has no zone keys a zone of model.zones; materials of the same name
// and colour share one. Keyed zones, which images ask for by key, stand before them.
void add_material_zones(const std::vector<bool> &used, model::Model &model);

}  // namespace claque::asset
