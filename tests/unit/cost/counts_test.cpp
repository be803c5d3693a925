// S0's tables as printed, typed here from the paper, compared with the results of samples/cost.
#include <gtest/gtest.h>

#include "samples/cost/operations.h"
#include "samples/cost/readings.h"

namespace cost
{
namespace
{

const Scene counted_scene;

void expect_counts(const Counts &computed, const Counts &paper)
{
    for (size_t i = 0; i < operation_count; ++i)
        EXPECT_NEAR(computed[i], paper[i], 1e-9) << name_of(static_cast<Operation>(i));
}

TEST(Counts, Table2AddsUp)
{
    EXPECT_EQ(counted_scene.actors(), 100);
    EXPECT_EQ(counted_scene.refpoint_crossing(), 50);
    EXPECT_EQ(counted_scene.root_crossing(), 10);
}

TEST(Counts, Table4FollowsFromTable2)
{
    const Factors f = factors_of(counted_scene);
    EXPECT_DOUBLE_EQ(f.actors, 100);
    EXPECT_DOUBLE_EQ(f.refpoint_in, 0.3);
    EXPECT_DOUBLE_EQ(f.root_out, 0.2);
    EXPECT_DOUBLE_EQ(f.root_in, 0.2);
    EXPECT_DOUBLE_EQ(f.root_crossing, 0.08);
    EXPECT_DOUBLE_EQ(f.check_internal, 0.02);
    EXPECT_DOUBLE_EQ(f.nodes_per_actor, 40);
    EXPECT_DOUBLE_EQ(f.spheres_per_actor, 80);
    EXPECT_DOUBLE_EQ(f.nodes_kept, 0.5);
}

TEST(Counts, Table5OfTraditionalProcessingIsThePaperS)
{
    expect_counts(counts_of_table_5(factors_of(counted_scene), Processing::traditional),
                  {4000, 100, 100, 8200, 460, 4100});
}

TEST(Counts, Table5OfActorProcessingIsThePaperSButForNO04b)
{
    // The paper prints 200.
    expect_counts(counts_of_table_5(factors_of(counted_scene), Processing::actor), {400, 100, 30, 160, 220, 100});
}

TEST(Counts, ThePrintedReadingIsTable5AsPrinted)
{
    expect_counts(as_printed().actor_counts, {400, 100, 30, 160, 200, 100});
    expect_counts(as_printed().traditional_counts, {4000, 100, 100, 8200, 460, 4100});
}

TEST(Counts, EightyPassTheFirstCullAndSixtyTheSecond)
{
    EXPECT_EQ(counted_scene.pass_first_cull(), 80);
    EXPECT_EQ(counted_scene.pass_second_cull(), 60);
}

TEST(Counts, ByTheOrderOfWorkEveryActorThatPassesIsCounted)
{
    // 60 x 20 nodes; 80 roots; 10 x 80 spheres; 100 + 50 + 8 + 2 x 40 tests; 60 distances.
    expect_counts(counts_by_order_of_work(counted_scene, Processing::actor), {1200, 100, 80, 800, 238, 60});
    expect_counts(counts_by_order_of_work(counted_scene, Processing::traditional), {4000, 100, 100, 8200, 238, 4100});
}

TEST(Counts, TheOrderOfWorkFollowsTheSceneAndNotThePaperS)
{
    Scene other;  // 10 actors: 4 outside, 1 within, 5 on the edge
    other.outside = 4;
    other.refpoint_within = 1;
    other.root_outside = 2;
    other.root_within = 1;
    other.internal_decided = 1;
    other.internal_crossing = 1;
    other.nodes_per_actor = 6;
    other.spheres_per_actor = 10;
    expect_counts(counts_by_order_of_work(other, Processing::actor), {4 * 3, 10, 6, 20, 10 + 5 + 1 + 5, 4});
    expect_counts(counts_of_table_5(factors_of(other), Processing::actor), {3, 10, 1, 10, 10 + 2 + 1 + 5, 10});
}

TEST(Counts, FormulasInWordsNameTheFactorsTheyUse)
{
    EXPECT_STREQ(table_5(no_03, Processing::actor).words, "nActors x fRefpointBsphsIn");
    EXPECT_STREQ(by_order_of_work(no_03, Processing::actor).words, "B + C");
}

}  // namespace
}  // namespace cost
