// What a compressed file says of its sizes is weighed before its decoder takes memory for them.
#include "packed.h"

#include <gtest/gtest.h>

#include "../asset/decoder_test.h"
#include "../asset/heap_meter.h"

namespace claque::testing
{
namespace
{

constexpr uint64_t mega = 1u << 20;

struct Loaded {
    Outcome outcome;
    uint64_t peak = 0;
};

Loaded load_with(const Bytes &bytes, uint64_t limit_bytes)
{
    asset::LoadOptions options;
    options.memory_limit_bytes = limit_bytes;
    Loaded out;
    out.peak = peak_heap_bytes([&] { out.outcome = outcome_of(bytes, options); });
    return out;
}

TEST(PackedMemory, OfDracosTrianglesIsWeighedBeforeItDecodes)
{
    CLAQUE_NEEDS_DECODER(asset::Decoder::draco, "libdraco");
    for (const bool edgebreaker : {false, true}) {
        const PackedFile file = draco_sheet(60000, edgebreaker);  // 64 bytes for each of its 180 000 indices: 11.5 MB
        const Loaded fits = load_with(file.bytes, 32 * mega), refused = load_with(file.bytes, 8 * mega);
        EXPECT_EQ(fits.outcome.text, "");
        EXPECT_EQ(refused.outcome.status, CLQ_LIMIT) << refused.outcome.text;
        EXPECT_NE(refused.outcome.text.find("triangles need more than the"), std::string::npos) << refused.outcome.text;
        EXPECT_LT(refused.peak, mega);
        EXPECT_GT(fits.peak, 2 * mega);
    }
}

TEST(PackedMemory, OfDracosNumbersIsWeighedBeforeTheyAreDecoded)
{
    CLAQUE_NEEDS_DECODER(asset::Decoder::draco, "libdraco");
    for (const bool edgebreaker : {false, true}) {
        // 12 bytes for each of 103 numbers of 10 000 vertices: 12.4 MB.
        const PackedFile file = draco_sheet(20000, edgebreaker, 100);
        const Loaded fits = load_with(file.bytes, 32 * mega), refused = load_with(file.bytes, 8 * mega);
        EXPECT_EQ(fits.outcome.text, "");
        EXPECT_EQ(refused.outcome.status, CLQ_FORMAT) << refused.outcome.text;
        EXPECT_NE(refused.outcome.text.find("its 103 numbers for each of"), std::string::npos) << refused.outcome.text;
    }
}

}  // namespace
}  // namespace claque::testing
