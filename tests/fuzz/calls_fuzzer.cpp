// Calls of the C API, chosen by bytes: the laws of tests/api/fuzz_test.cpp hold for each, and drawing reads no array
// beyond its end.
#include "tests/api/fuzz_world.h"
#include "tests/fuzz/fuzzer.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size == 0) return 0;
    TestWorld::keeps_templates = true;
    fuzz::Options options;
    options.steps = 500;
    options.choices = {bytes, size};
    options.records = bytes[0] % 4 == 0;
    fuzz::World world(1, options);
    world.run();
    return 0;
}
