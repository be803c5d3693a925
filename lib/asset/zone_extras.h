// Zone keys (S1 3) in the alpha of an image, declared in the `extras` of the image or of a material for its base colour
// image. The format leaves the content of extras to applications.
//
//   "extras": {"claque": {"zones": [
//       {"name": "tunic",             required, not empty
//        "key": 140,                  required, 0 to 255: the alpha that marks this zone
//        "colour": [0.9, 0.9, 0.8],   the default colour of an individual, as for glColor; default: [1, 1, 1]
//        "hue_deg": [20, 50],         the range that colours are sampled from; hue wraps: [340, 20] goes through red
//        "saturation": [0.2, 0.4],    fractions, min <= max
//        "brightness": [0.6, 1]}      all three or none; if none, zone_ranges.h decides by name and colour
//   ]}}
//
// Unknown members are ignored. A key means the same zone in all images of a file.
#pragma once

#include "lib/asset/json_view.h"
#include "lib/model/model.h"

namespace claque::asset
{

// The zones that `extras` declares; empty if it declares none. Throws base::Error (CLQ_FORMAT) for a list that breaks
// the rules above.
std::vector<model::Zone> read_zone_extras(const JsonView &extras);

// Adds zones to a list in which each key belongs to one name. Throws base::Error (CLQ_FORMAT) for a key with two names.
void add_keyed_zones(std::vector<model::Zone> &to, const std::vector<model::Zone> &zones, const std::string &path);

}  // namespace claque::asset
