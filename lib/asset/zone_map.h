// Adds zones to characters that come without: a map of an image's texels becomes keys in its alpha (S1 3). The texels
// of reduced zones become grey, so that they can take light and dark colours alike (S2 2.3).
#pragma once

#include "lib/asset/near_colours.h"

namespace claque::asset
{

constexpr uint16_t unknown_zone = 0xffff;

struct ZoneMapZone {
    std::string name;
    bool reduced = false;  // its texels become grey, scaled to full brightness; else they keep their colours
    const model::HsbRange *range = nullptr;  // the range that colours are sampled from; null: as near_colours.h says
};

// A map of any size: each texel of the image takes the zone at its centre. Unknown texels take the nearest known zone.
struct ZoneMap {
    uint32_t width = 0, height = 0;
    // [width * height] indices of the map's zones, or unknown_zone; row v = 0 first
    const uint16_t *zones = nullptr;
};

// Removes zones of the model that are no longer shown. A zone whose name another image's keys already use becomes the
// same zone. `colours`: of zones without a range; if they are wild, other zones of the model's materials stay too.
// Throws base::Error: CLQ_ARGUMENT for a value out of range, an image that no material shows or whose alpha
// cuts out, or a map without known texels; CLQ_LIMIT for more than 256 zones. The model is then unchanged.
void set_zone_map(model::Model &model, uint32_t image, const ZoneMap &map, const std::vector<ZoneMapZone> &zones,
                  Colours colours = Colours::near);

}  // namespace claque::asset
