// How a glTF file says that the alpha of an image holds zone keys (S1 3) and not opacity: in `extras`, which the format
// leaves to us, of an image or of a material (then for the image of its base colour).
//
//   "extras": {"claque": {"zones": [
//       {"name": "tunic",             required, not empty
//        "key": 140,                  required, 0 to 255: the alpha that means this zone
//        "colour": [0.9, 0.9, 0.8],   of an individual that was given none, as glColor takes it; [1, 1, 1]
//        "hue_deg": [20, 50],         what colours are drawn from: a circle, so that [340, 20] goes through red;
//        "saturation": [0.2, 0.4],    fractions, first <= last;
//        "brightness": [0.6, 1]}      all three, or none: then zone_ranges.h decides by name and colour
//   ]}}
//
// Unknown members are passed over. A key means the same zone in all images of a file.
#pragma once

#include "lib/asset/json_view.h"
#include "lib/model/model.h"

namespace claque::asset
{

// The zones that `extras` declares; empty where it says nothing about them. Throws base::Error (CLQ_FORMAT) for a
// list that breaks the rules above.
std::vector<model::Zone> read_zone_extras(const JsonView &extras);

// Adds zones to a list in which a key stands for one name. Throws base::Error (CLQ_FORMAT) where it stands for two.
void add_keyed_zones(std::vector<model::Zone> &to, const std::vector<model::Zone> &zones, const std::string &who);

}  // namespace claque::asset
