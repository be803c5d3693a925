// The part of the panel Designer that paints zones over a texture.
#pragma once

#include "samples/view/designer/zone_picture.h"
#include "samples/view/ui.h"
#include "samples/view/world.h"

namespace view
{

// The texture that is shown, to pick a zone on it or to paint it.
void texture_of_zones(Ui &ui, Designer &designer, const clq_template *tmpl, bool paintable);

// The image of an asset that shows what a map was painted over. Throws scenes::Failure if none is like it.
uint32_t image_for(const clq_asset *asset, const ZoneMap &map);
// Gives the asset the zones of a map.
void give_zones(clq_context *context, clq_asset *asset, const ZoneMap &map);
// A proposal of the library's in place of the map's zones.
SharedMap proposed(const clq_asset *asset, const ZoneMap &over, uint32_t most_zones);

}  // namespace view
