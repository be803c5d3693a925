// Candidate levels and the choice of those that form a character's chain. Internal to lib/lod.
#pragma once

#include <cstddef>
#include <vector>

#include "lib/lod/chain.h"
#include "lib/lod/surface/area_fractions.h"

namespace claque::lod
{

constexpr double max_zone_view_error = 0.28;  // of levels of fewer than 20 triangles (zone_views.h)

struct Candidate {
    LevelReport level;
    bool is_proxy = false;  // one part, split by lighting at the end, replaces all parts
    bool is_measured = false;
    double zone_tolerance = max_zone_area_error;  // what its zones' area fractions may be off
    bool loses_zone = false;                      // see area_fractions.h
    size_t target = 0;                            // the number of triangles that was asked for
    std::vector<model::Part> parts;
};

size_t triangle_count_of(const Candidate &made);

// Removes useless candidates: levels whose distance does not exceed the one before, levels that hardly save triangles,
// and levels below 20 triangles whose zones have other area fractions, are lost, or look wrong in single views.
std::vector<Candidate> prune(std::vector<Candidate> all);

// Moves levels to where their textures look as the finest one's, if that is farther. Decimated levels and proxies are
// chosen by their shapes, so this comes after the choice.
void raise_distances(std::vector<Candidate> &all, double tolerance_px);

// Of a decimated level and a proxy with similar triangle counts, keeps the one with the smaller error. `made` keeps the
// decimated levels of these pairs; `proxy_targets` keeps the targets that become proxies.
void prefer_near(std::vector<Candidate> &made, std::vector<size_t> &proxy_targets);

// Finds decimated levels with a larger error than a proxy of fewer triangles, and drops them and all coarser decimated
// levels from `made`; `proxy_targets` gets their targets. Returns false if there are none.
bool replace_by_proxy(std::vector<Candidate> &made, std::vector<size_t> &proxy_targets);

// Returns the model's parts, with the parts at `part_indices` replaced by their versions in all levels. Proxies, which
// replace all of these parts, come last.
std::vector<model::Part> assemble(const model::Model &model, const std::vector<size_t> &part_indices,
                                  std::vector<Candidate> made);

}  // namespace claque::lod
