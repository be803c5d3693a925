// A broken law ends libFuzzer, which then keeps the input.
#include <csignal>
#include <cstdlib>

#include <gtest/gtest.h>

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    testing::FLAGS_gtest_break_on_failure = true;
    std::signal(SIGTRAP, [](int) { std::abort(); });  // GoogleTest raises it; libFuzzer keeps inputs that abort
    return 0;
}
