// Structs that grow: hosts of every released header are served, all other sizes are refused.
#include "lib/api/struct_size.h"

#include <gtest/gtest.h>

namespace
{

// As a later version may have it: the first release ended with `first`.
struct Grown {
    uint32_t struct_bytes;
    uint32_t first;
    uint32_t second;
};

Grown grown_init() { return {sizeof(Grown), 10, 20}; }

}  // namespace

template <>
struct claque::api::EarlierSizes<Grown> {
    static constexpr uint32_t sizes[] = {8};
};

namespace
{

using namespace claque;

TEST(StructSize, MembersThatAShorterDefLacksGetTheirDefaults)
{
    const Grown host = {8, 1, 2};
    const Grown def = api::read_def(&host, grown_init, "grown_init");
    EXPECT_EQ(def.first, 1u);
    EXPECT_EQ(def.second, 20u);
    EXPECT_EQ(def.struct_bytes, sizeof(Grown));
}

TEST(StructSize, AnOutStructIsWrittenAsFarAsItGoes)
{
    Grown host = {8, 1, 2};
    api::require_size(host, "grown_init");
    api::write_out(&host, Grown{sizeof(Grown), 5, 6});
    EXPECT_EQ(host.struct_bytes, 8u);
    EXPECT_EQ(host.first, 5u);
    EXPECT_EQ(host.second, 2u) << "beyond the host's struct";
}

TEST(StructSize, EveryOtherSizeIsRefused)
{
    for (const uint32_t size : {0u, 4u, 7u, 9u, 11u, 13u, 16u, 0xffffffffu}) {
        const Grown host = {size, 1, 2};
        EXPECT_THROW(api::require_size(host, "grown_init"), base::Error) << size;
    }
}

}  // namespace
