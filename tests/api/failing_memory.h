// Memory that fails on request: the host's allocator, operator new and malloc of this program share one countdown.
#pragma once

#include <claque/base.h>

namespace failing_memory
{

enum class Reach { host_only, everything };

// From now on the n-th allocation fails and, if `persistent`, all later ones. n = 0: none fails, they are only counted.
void arm(uint64_t n, Reach reach, bool persistent = false);
uint64_t disarm();     // number of allocations since arm()
int64_t host_bytes();  // held now through the host's allocator

extern const clq_allocator allocator;

}  // namespace failing_memory
