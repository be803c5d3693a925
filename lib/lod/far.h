// Levels of detail for characters that are a few dozen pixels tall: one closed surface in place of all parts (shell.h).
// Each triangle shows the one zone that most of what it stands for shows, and texture coordinates point into an image of
// a few texels, one for each zone and brightness, so that every triangle is clean and the zone law holds to the letter.
#pragma once

#include <vector>

#include "lib/model/model.h"

namespace claque::lod
{

struct FarWish {
    std::vector<size_t> targets;          // triangles, descending strictly
    double influence = 0.1, zone = 0.05;  // as in ShellWish
};

struct FarLevels {
    std::vector<model::Part> parts;  // one for each target, finest first; `material` is that of `model` behind its last
    model::Material material;        // its image is that of `model` behind its last
    model::Image image;              // keys of the model's zones
    std::vector<uint8_t>
        zone_keys;  // [zones] that the image uses: the model's own, or new ones where those do not tell zones apart
};

// `source` are triangle parts of `model`, which has passed model::check. Throws base::Error (CLQ_LIMIT) where zones are more than keys. Deterministic.
FarLevels make_far(const model::Model &model, const std::vector<const model::Part *> &source, const FarWish &wish);

}  // namespace claque::lod
