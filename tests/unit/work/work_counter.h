// Counts what a piece of work does by the basic blocks that it enters: the library claque_counted is compiled with a
// call at each of them. The count depends on neither the machine nor its load.
#pragma once

#include <cstdint>
#include <functional>

namespace claque::testing
{

uint64_t blocks_entered(const std::function<void()> &job);
// Since the calling thread began.
uint64_t blocks_entered();

}  // namespace claque::testing
