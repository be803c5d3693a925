// A broken law ends libFuzzer, which then keeps the input.
#include <gtest/gtest.h>

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    testing::FLAGS_gtest_break_on_failure = true;
    return 0;
}
