// Renumbered zone keys and the alpha tests that distinguish them.
#include "lib/model/keys.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/error.h"

namespace claque::test
{

using model::Keys;

namespace
{

// A GL's arithmetic: the product rounded to the nearest of 2^bits - 1 steps, compared with the stored reference.
bool passes(uint8_t texel, double vertex_alpha, double reference, int bits, bool rounds_reference)
{
    const double steps = std::ldexp(1.0, bits) - 1;
    const double alpha = std::floor(texel / 255.0 * vertex_alpha * steps + 0.5);
    const double against = rounds_reference ? std::floor(reference * steps + 0.5) : reference * steps;
    return alpha >= against;
}

using List = std::vector<uint8_t>;
bool fused_take(const List &keys, uint32_t bits) { return model::fused_accepts(Keys(keys), bits); }
bool passes_take(const List &keys, uint32_t bits) { return model::passes_accept(Keys(keys), bits); }

}  // namespace

TEST(Keys, AscendStrictlyTo255WithoutKey0ForEveryCount)
{
    for (uint32_t n = 1; n <= 255; ++n) {
        const auto keys = model::geometric_keys(n);
        ASSERT_EQ(keys.size(), n);
        EXPECT_GT(keys[0], 0) << n;
        EXPECT_EQ(keys[n - 1], 255) << n;
        for (uint32_t i = 1; i < n; ++i) ASSERT_GT(keys[i], keys[i - 1]) << n;
    }
    EXPECT_THROW(model::geometric_keys(0), base::Error);
    EXPECT_THROW(model::geometric_keys(257), base::Error);
}

TEST(Keys, GoFrom94InNearlyEqualRatios)
{
    const auto keys = model::geometric_keys(8);
    EXPECT_EQ(keys[0], 94);
    for (size_t i = 1; i < keys.size(); ++i)
        EXPECT_NEAR(double(keys[i]) / keys[i - 1], std::pow(255.0 / 94, 1.0 / 7), 0.01);
}

TEST(Keys, ARaisedCopyShowsExactlyItsZoneAndThoseAboveOn8Bits)
{
    for (uint32_t n = 2; n <= model::fused_limit(8); ++n) {
        const auto keys = model::geometric_keys(n);
        const model::FusedTable table = model::fused_table(Keys(keys));
        for (uint32_t zone = 0; zone < n; ++zone)
            for (uint32_t texel = 0; texel < n; ++texel)
                for (const bool rounds : {false, true})
                    for (const double alpha : {double(table.alpha[zone]), table.alpha_8bit[zone] / 255.0})
                        ASSERT_EQ(passes(keys[texel], alpha, double(table.reference), 8, rounds), texel >= zone)
                            << n << " zones, zone " << zone << ", texel " << texel;
        for (uint32_t zone = 0; zone < n; ++zone)
            EXPECT_FALSE(passes(0, table.alpha[zone], double(table.reference), 8, true)) << "a hole is visible";
    }
}

TEST(Keys, APassShowsExactlyItsZoneAndThoseAboveUpTo255Zones)
{
    EXPECT_GE(model::passes_limit(8), 255u);
    for (const uint32_t n : {1u, 2u, 8u, 48u, 162u, 163u, 255u}) {
        const auto keys = model::geometric_keys(n);
        for (uint32_t zone = 0; zone < n; ++zone) {
            const double reference = double(model::pass_reference(Keys(keys), zone));
            EXPECT_FALSE(passes(0, 1, reference, 8, true));
            for (uint32_t texel = 0; texel < n; ++texel)
                for (const bool rounds : {false, true})
                    ASSERT_EQ(passes(keys[texel], 1, reference, 8, rounds), texel >= zone);
        }
    }
}

TEST(Keys, FusedTakesAboutFiftyZonesOn8BitsAndRefusesWhatRoundingWouldMix)
{
    EXPECT_GE(model::fused_limit(8), 48u);
    EXPECT_LE(model::fused_limit(8), 80u);
    EXPECT_GE(model::fused_limit(24), model::fused_limit(8));
    EXPECT_LT(model::fused_limit(5), 4u);
    EXPECT_FALSE(fused_take(model::geometric_keys(120), 8));
    EXPECT_FALSE(fused_take({0, 128, 255}, 8)) << "a lowest key of 0 is a hole";
    EXPECT_FALSE(fused_take({94, 254, 255}, 8));
    EXPECT_TRUE(passes_take({94, 254, 255}, 8));
    EXPECT_FALSE(passes_take({94, 254, 255}, 4));
}

}  // namespace claque::test
