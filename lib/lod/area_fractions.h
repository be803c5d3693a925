// How much of what is seen of a surface shows each zone.
#pragma once

#include <vector>

#include "lib/lod/surface_samples.h"

namespace claque::lod
{

// [zones of `model` + 1] shares, their sum 1, of the area on which parts at rest show each zone, each piece of it as much as it
// can be seen (seen.h): what clothes hide does not count. The last: no zone. All 0 where there is no area. Parts have passed model::check. `set`: one of the model's texture sets; null: the first.
std::vector<double> zone_area_fractions(const model::Model &model, const std::vector<const model::Part *> &parts,
                                        const model::TextureSet *set = nullptr);

// Of parts that are at rest, where it is known how much of them is seen.
std::vector<double> zone_area_fractions(const model::Model &model, const PosedParts &rest,
                                        const std::vector<double> &visibility, const model::TextureSet *set = nullptr);

// The largest difference of two such, [0, 1].
double zone_area_error(const std::vector<double> &a, const std::vector<double> &b);

}  // namespace claque::lod
