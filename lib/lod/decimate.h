// Fewer triangles for the same look: edges are collapsed onto one of their ends in the order of quadric error, so that
// every vertex that is left is one of the source's, with its influences, normal and place in the texture.
//
// Seams stay shut: vertices that share a position move together, and an edge is collapsed only where every vertex that
// goes has a partner of its own side at the end that stays. Open borders are collapsed only along themselves.
#pragma once

#include <cstddef>

#include "lib/model/model.h"

namespace claque::lod
{

struct Decimation {
    size_t target_triangles = 0;
    float normal_turn_deg = 60;  // no triangle may turn further in one collapse
};

struct Decimated {
    model::Part part;  // topology triangles, with indices
    size_t triangles = 0;
    size_t refused = 0;  // source triangles on non-manifold edges: kept as they are, beyond the target if need be
};

// `part` has passed model::check. Stops above the target where no lawful collapse is left. Throws base::Error
// (CLQ_ARGUMENT) for parts that have morph targets or no triangles. Deterministic.
Decimated decimate(const model::Part &part, const Decimation &wish);

}  // namespace claque::lod
