// Runs work that may crash, hang or eat memory in a process of its own, and brings back its bytes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace convert
{

struct Limits {
    uint64_t memory_bytes = 2ull << 30;  // of the child's address space, and of what it sends
    uint32_t seconds = 120;              // of the clock and of the processor
};

// Returns what `work` returns in the child. Throws scenes::Failure with one sentence that begins with `what`: the text
// of what `work` threw, or how the child ended. The child's own output goes nowhere. The process must have one thread.
std::string run_in_child(const std::string &what, const Limits &limits, const std::function<std::string()> &work);

}  // namespace convert
