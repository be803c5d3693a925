// What of a character's surface can be seen at all: skin under clothes and the inside of a mouth cannot, and what a level does
// with them does not show. Between the files of this room only.
#pragma once

#include "lib/base/services.h"
#include "lib/lod/surface_samples.h"

namespace claque::lod
{

// [triangles of `parts`, which are at rest] the share of directions, all round, from which an eye far away sees it past all
// the others: about half for what lies open, none for what is hidden; from the back only where its material has two sides. From
// one of fourteen alone, as legs are from below in a skirt, is hidden. All 1 where nothing
// could be seen. Deterministic, whatever the jobs.
std::vector<double> visibility_of(const model::Model &model, const PosedParts &parts, const base::Jobs &jobs = {});

// The same of triangles that are no parts, judged by four of their places, or in haste by their middles alone.
struct VisibilityQuery {
    std::array<glm::dvec3, 3> corners;
    bool two_sided = false;  // shown from the back as well
};
enum class VisibilityQuality : uint8_t { fast, full };
std::vector<double> visibility_of(const std::vector<VisibilityQuery> &queries,
                                  VisibilityQuality quality = VisibilityQuality::full, const base::Jobs &jobs = {});
bool is_two_sided(const model::Model &model, const model::Part &part);

// Their areas, each times that share.
std::vector<double> visible_areas(const model::Model &model, const PosedParts &parts);

}  // namespace claque::lod
