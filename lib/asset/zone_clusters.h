// Proposes a zone map for an image that has none, by clustering texels of similar colour.
#pragma once

#include "lib/model/model.h"

namespace claque::asset
{

struct ZoneProposal {
    uint32_t width = 0, height = 0;             // of the image
    std::vector<uint16_t> zones;                // one per texel; unknown_zone (zone_map.h) where no triangle lies
    std::vector<std::array<uint8_t, 3>> means;  // the mean colour of each zone's texels, most texels first
};

// At most `count` zones; fewer if colours do not differ enough. Lightness counts half as much as colour, since folds
// and shadows belong to one cloth. Isolated texels join their neighbours. Deterministic. Throws base::Error
// (CLQ_ARGUMENT) if the image is out of range or shown by no triangle, or `count` is 0 or above 48.
ZoneProposal propose_zones(const model::Model &model, uint32_t image, uint32_t count);

}  // namespace claque::asset
