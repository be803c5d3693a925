// Levels that were made, of which some come to be a character's chain. Between the files of this room only.
#pragma once

#include <cstddef>
#include <vector>

#include "lib/lod/chain.h"

namespace claque::lod
{

constexpr double max_zone_area_error = 0.02;  // of the share of any zone, at any level

struct Candidate {
    LevelReport level;
    bool is_proxy = false;  // one part in place of all
    bool is_measured = false;
    std::vector<model::Part> parts;
};

size_t triangle_count_of(const Candidate &made);

// Distances must ascend, a level that serves nowhere costs memory for nothing, and a dozen triangles may be too few for zones.
std::vector<Candidate> prune(std::vector<Candidate> all);

// Of a near and a far level of about as many triangles the one that is nearer shall be. `made` is left with the near ones of
// these, `far_targets` with what is to be far.
void prefer_near(std::vector<Candidate> &made, std::vector<size_t> &proxy_targets);

// Near levels that are further off than a far one of fewer triangles, and those below them: far ones of as many shall
// take their places. False where there are none; else `made` is left with the near ones that stay.
bool replace_by_proxy(std::vector<Candidate> &made, std::vector<size_t> &proxy_targets);

// The model's parts with those at `places` in all levels; far ones, which stand for all of them, at the end.
std::vector<model::Part> assemble(const model::Model &model, const std::vector<size_t> &part_indices,
                                  std::vector<Candidate> made);

}  // namespace claque::lod
