// A proposal for a zone map where nobody painted one: texels of like colours, found by clustering.
#pragma once

#include "lib/model/model.h"

namespace claque::asset
{

struct ZoneProposal {
    uint32_t width = 0, height = 0;             // of the image
    std::vector<uint16_t> zones;                // one a texel; unknown_zone (zone_map.h) where no triangle lies
    std::vector<std::array<uint8_t, 3>> means;  // of each zone's texels, most texels first
};

// At most `count` zones, fewer where colours do not differ enough. Light and dark count half as much as colour, since folds
// and shadows are of one cloth; lone texels go with those round them. Deterministic. Throws base::Error (CLQ_ARGUMENT): an
// image out of range or that no triangle shows, a count of 0 or above 48.
ZoneProposal propose_zones(const model::Model &model, uint32_t image, uint32_t count);

}  // namespace claque::asset
