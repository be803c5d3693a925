// Memory that fails on request: the host's allocator, operator new and malloc of this program share one countdown.
#pragma once

#include <claque/base.h>

#include <vector>

namespace failing_memory
{

enum class Reach { host_only, everything };

// From now on the n-th allocation fails and, if `persistent`, all later ones. n = 0: none fails, they are only counted.
void arm(uint64_t n, Reach reach, bool persistent = false);
uint64_t disarm();     // number of allocations since arm()
int64_t host_bytes();  // held now through the host's allocator
int64_t blocks();      // held now in all: the host's, operator new's and, where malloc is ours, malloc's

// Allocations meanwhile are the test's own: not counted, never failed.
class Unarmed
{
public:
    Unarmed();
    ~Unarmed();
    Unarmed(const Unarmed &) = delete;
    Unarmed &operator=(const Unarmed &) = delete;

private:
    bool was_armed_;
};

// A place that allocates: a hash of the return addresses above it, up to the function that called arm(); the same in a
// child of fork().
using Place = uint64_t;
void note_places(std::vector<Place> *out, uint32_t frames);  // of all allocations while armed; null: of none
Place failed_place();                                        // of the last allocation that was failed; 0: none yet

extern const clq_allocator allocator;

}  // namespace failing_memory
