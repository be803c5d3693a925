// A texture of a template as the designer's panel shows it: light and dark in the colours of the class, the chosen zone
// bright among the others.
#pragma once

#include "samples/view/designer/designer.h"

namespace view
{

struct ZonePicture {
    const clq_template *tmpl = nullptr;
    uint32_t set = 0, texture = 0, width_px = 0, height_px = 0;
    SharedClass colours;
    std::string owner, zone;                            // names of the template and of the chosen zone
    SharedMap map;                                      // null: the zones are the template's
    std::vector<std::string> names;                     // of the zones
    std::vector<uint32_t> zones;                        // [width_px * height_px]; beyond the names in holes
    std::shared_ptr<const std::vector<uint8_t>> light;  // [3 * width_px * height_px]
    int side_px = 0;
    std::vector<uint8_t> rgba;  // [4 * side_px * side_px], the row at v = 0 first
    uint64_t number = 0;        // of its content

    // The name of the zone at a place of the texture, 0 to 1 each way; "" in holes.
    std::string at(float u, float v) const;
    // The zones as a map to paint on.
    std::shared_ptr<ZoneMap> painted() const;
};

// The picture of what is chosen; `last` where it is the same.
std::shared_ptr<const ZonePicture> picture_of(const clq_template *tmpl, const Designer &designer,
                                              const std::shared_ptr<const ZonePicture> &last);

}  // namespace view
