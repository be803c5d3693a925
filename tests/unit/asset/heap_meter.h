// How much of the C++ heap a piece of work has at once, by operator new and delete of this executable.
#pragma once

#include <cstdint>
#include <functional>

namespace claque::testing
{

// Most bytes held at one time above what was held before.
uint64_t peak_heap_bytes(const std::function<void()> &job);

}  // namespace claque::testing
