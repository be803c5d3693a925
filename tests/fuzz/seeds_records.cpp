// Records of short runs.
#include "tests/api/record_fixture.h"
#include "tests/fuzz/seeds.h"

namespace fuzzing
{

void add_record_seeds(std::vector<Seed> &out)
{
    TestWorld world;
    for (const uint32_t steps : {1u, 6u, 24u}) {
        const Bytes bytes = records::run(world, steps, steps, 500).bytes;
        out.push_back({"record", "steps" + std::to_string(steps), bytes});
        out.push_back({"record", "cut" + std::to_string(steps), Bytes(bytes.begin(), bytes.end() - 40)});
    }
}

}  // namespace fuzzing
