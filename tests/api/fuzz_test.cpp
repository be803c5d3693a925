// Random calls of the C API, with valid and invalid arguments, stale ids and failing memory: every call keeps the rules
// of all calls, and what the host knows of the crowd stays true.
#include "tests/api/failing_memory.h"
#include "tests/api/fuzz_world.h"

namespace fm = failing_memory;

namespace
{

void fail_now_and_then(uint64_t bits)
{
    if (bits % 4 == 0) fm::arm(1 + (bits >> 8) % 12, fm::Reach::everything, (bits >> 20) % 2 == 0);
}

}  // namespace

TEST(Fuzz, CallsAtRandomKeepToTheLaws)
{
    uint32_t good = 0, bad = 0, drawn = 0, picked = 0, deferred = 0, key_posed = 0, packed = 0;
    for (uint64_t seed = 1; seed <= 22 && !HasFailure(); ++seed) {
        fuzz::Options options;
        options.steps = 4000;
        fuzz::World world(seed, options);
        world.run();
        good += world.good(), bad += world.bad(), drawn += world.drawn();
        picked += world.picked();
        deferred += world.deferred(), key_posed += world.key_posed(), packed += world.packed();
    }
    EXPECT_GT(good, 40000u);
    EXPECT_GT(bad, 15000u);
    EXPECT_GT(drawn, 5000u);
    EXPECT_GT(picked, 15u);
    EXPECT_GT(deferred, 500u);
    EXPECT_GT(key_posed, 5000u);
    EXPECT_GT(packed, 1000u);
}

TEST(Fuzz, CallsAtRandomAreMadeAgainByTheirRecord)
{
    for (uint64_t seed = 201; seed <= 210 && !HasFailure(); ++seed) {
        fuzz::Options options;
        options.steps = 2000;
        options.records = true;
        fuzz::World world(seed, options);
        world.run();
    }
}

TEST(Fuzz, CallsAtRandomKeepToTheLawsWhereMemoryFails)
{
    clq_context_def context = clq_context_def_init();
    context.allocator = fm::allocator;
    for (uint64_t seed = 101; seed <= 110 && !HasFailure(); ++seed) {
        fuzz::Options options;
        options.steps = 1500;
        options.context = &context;
        options.before = fail_now_and_then;
        options.after = [] { fm::disarm(); };
        fuzz::World world(seed, options);
        world.run();
    }
    EXPECT_EQ(fm::host_bytes(), 0);
}
