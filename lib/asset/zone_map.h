// Zones for characters that come without: a map of an image's texels becomes keys in its alpha (S1 3), and zones that are
// to take light and dark colours alike lose their own for light and dark (S2 2.3).
#pragma once

#include "lib/model/model.h"

namespace claque::asset
{

constexpr uint16_t unknown_zone = 0xffff;

struct ZoneMapZone {
    std::string name;
    bool reduced = false;  // its texels become grey, stretched to full brightness; else they keep their colours
    const model::HsbRange *range = nullptr;  // what colours are drawn from; null: as zone_ranges.h says
};

// Of any size: each texel of the image takes what lies at its middle. Unknown ones take the nearest that is known.
struct ZoneMap {
    uint32_t width = 0, height = 0;
    const uint16_t *zones = nullptr;  // [width * height] numbers of painted zones, or unknown_zone; row v = 0 first
};

// Zones of the model that nothing shows any longer are dropped; a zone of the same name that another image's keys mean
// becomes the same zone. Throws base::Error (CLQ_ARGUMENT) for what is out of range, an image that no material shows or
// that cuts out by its alpha, a map without any known texel; CLQ_LIMIT for more than 256 zones. The model is then as it was.
void set_zone_map(model::Model &model, uint32_t image, const ZoneMap &map, const std::vector<ZoneMapZone> &zones);

}  // namespace claque::asset
