// The fraction of the visible surface that shows each zone.
#pragma once

#include <vector>

#include "lib/lod/surface/surface_samples.h"

namespace claque::lod
{

// Returns [zones of `model` + 1] fractions of the visible area of `parts` at rest; the last is for no zone. Their sum
// is 1, or all are 0 where there is no area. Each triangle counts by its area times its visibility (visibility.h), so
// surface under clothes does not count. The parts must have passed model::check. `set`: one of the model's texture
// sets; null: the first.
std::vector<double> zone_area_fractions(const model::Model &model, const std::vector<const model::Part *> &parts,
                                        const model::TextureSet *set = nullptr);

// The same for parts that are posed at rest and whose visibility is known.
std::vector<double> zone_area_fractions(const model::Model &model, const PosedParts &rest,
                                        const std::vector<double> &visibility, const model::TextureSet *set = nullptr);

// Returns the largest difference between two results, in [0, 1].
double zone_area_error(const std::vector<double> &a, const std::vector<double> &b);

constexpr double max_zone_area_error = 0.02;  // largest allowed error of any zone's area fraction
constexpr double least_zone = 0.01;           // smaller zones may vanish from a level

// Returns whether a zone of at least `least` of the source shows less than a tenth of that in the level.
bool loses_zone(const std::vector<double> &source, const std::vector<double> &level, double least = least_zone);

}  // namespace claque::lod
