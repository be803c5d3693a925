// Decimation by a quadric alone, the baseline of levels of detail: it reaches its targets and does nothing else.
#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/figures/figure.h"
#include "lib/lod/chain.h"
#include "lib/lod/decimation/decimate.h"

using namespace claque;

TEST(QuadricOnly, ReachesItsTargetsWhereSeamsAndBordersHoldNothing)
{
    const model::Model citizen = figures::citizen();
    const std::vector<lod::Decimated> quadric_only = lod::decimate_quadric_only({{&citizen.parts[0]}}, {500, 100, 40});
    ASSERT_EQ(quadric_only.size(), 3u);
    EXPECT_LE(quadric_only[0].triangles, 500u);
    EXPECT_LE(quadric_only[1].triangles, 100u);
    EXPECT_LE(quadric_only[2].triangles, 40u);
    for (const lod::Decimated &level : quadric_only) {
        model::Model shown = figures::citizen();
        shown.parts = level.parts;
        EXPECT_NO_THROW(model::check(shown));
        EXPECT_EQ(level.parts[0].indices.size(), 3 * level.triangles);
    }
}

TEST(QuadricOnly, TurnsTrianglesOverInTheirTextureWhereClaqueDoesNot)
{
    const model::Model citizen = figures::citizen();
    lod::DecimationOptions decimation;
    decimation.targets = {600};
    EXPECT_GT(lod::decimate_quadric_only({{&citizen.parts[0]}}, {600})[0].flipped, 5u);
    EXPECT_EQ(lod::decimate({{&citizen.parts[0]}}, decimation)[0].flipped, 0u);
}

TEST(QuadricOnly, KeepsAllLevelsWithAscendingDistances)
{
    model::Model citizen = figures::citizen();
    lod::ChainOptions options;
    options.quadric_only = true;
    options.sampling.max_clips = 0;
    options.targets = {600, 590, 300, 60};
    const std::vector<lod::LevelReport> chain = lod::make_chain(citizen, options);
    ASSERT_EQ(chain.size(), 5u);
    for (size_t k = 1; k < chain.size(); ++k) EXPECT_GT(chain[k].distance_m, chain[k - 1].distance_m);
    EXPECT_NO_THROW(model::check(citizen));
}

TEST(QuadricOnly, RefusesWhatItCannotDo)
{
    const model::Part empty;
    EXPECT_THROW(lod::decimate_quadric_only({{&empty}}, {10}), base::Error);
}
