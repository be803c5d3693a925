#include "work_counter.h"

namespace
{

thread_local uint64_t entered = 0;

}  // namespace

// The name that -fsanitize-coverage=trace-pc calls.
extern "C" void __sanitizer_cov_trace_pc();
extern "C" void __sanitizer_cov_trace_pc() { ++entered; }

namespace claque::testing
{

uint64_t blocks_entered() { return entered; }

uint64_t blocks_entered(const std::function<void()> &job)
{
    const uint64_t before = entered;
    job();
    return entered - before;
}

}  // namespace claque::testing
