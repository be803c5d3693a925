// The ordered view of a host: individuals sorted by a number that it gives them, then by row.
#pragma once

#include <set>

#include "lib/model/rig.h"

namespace claque::scene
{

struct Keyed {
    double key;
    uint32_t row;
    friend bool operator<(const Keyed &a, const Keyed &b) { return a.key != b.key ? a.key < b.key : a.row < b.row; }
};

using Order = std::pmr::set<Keyed>;

// A node of the set in common implementations: the entry, three pointers and a colour.
constexpr uint64_t order_node_bytes = sizeof(Keyed) + 4 * sizeof(void *);

}  // namespace claque::scene
