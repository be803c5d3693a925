// Decimation by a quadric alone, what levels of detail are held against: it does what it says, and no more.
#include "lib/lod/plain.h"

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/figures/figure.h"
#include "lib/lod/chain.h"

using namespace claque;

TEST(Plain, reaches_its_targets_where_seams_and_borders_hold_nothing)
{
    const model::Model citizen = figures::citizen();
    const std::vector<lod::Decimated> plain = lod::decimated_plainly({{&citizen.parts[0]}}, {500, 100, 40});
    ASSERT_EQ(plain.size(), 3u);
    EXPECT_LE(plain[0].triangles, 500u);
    EXPECT_LE(plain[1].triangles, 100u);
    EXPECT_LE(plain[2].triangles, 40u);
    for (const lod::Decimated &level : plain) {
        model::Model shown = figures::citizen();
        shown.parts = level.parts;
        EXPECT_NO_THROW(model::check(shown));
        EXPECT_EQ(level.parts[0].indices.size(), 3 * level.triangles);
    }
}

TEST(Plain, turns_triangles_over_in_their_texture_where_claque_does_not)
{
    const model::Model citizen = figures::citizen();
    lod::Decimation how;
    how.targets = {600};
    EXPECT_GT(lod::decimated_plainly({{&citizen.parts[0]}}, {600})[0].flipped, 5u);
    EXPECT_EQ(lod::decimate({{&citizen.parts[0]}}, how)[0].flipped, 0u);
}

TEST(Plain, levels_are_all_kept_with_distances_that_go_up)
{
    model::Model citizen = figures::citizen();
    lod::ChainWish wish;
    wish.plain = true;
    wish.sampling.most_clips = 0;
    wish.targets = {600, 590, 300, 60};
    const std::vector<lod::ChainLevel> chain = lod::make_chain(citizen, wish);
    ASSERT_EQ(chain.size(), 5u);
    for (size_t k = 1; k < chain.size(); ++k) EXPECT_GT(chain[k].first_m, chain[k - 1].first_m);
    EXPECT_NO_THROW(model::check(citizen));
}

TEST(Plain, refuses_what_it_cannot_do)
{
    const model::Part empty;
    EXPECT_THROW(lod::decimated_plainly({{&empty}}, {10}), base::Error);
}
