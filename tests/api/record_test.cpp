// A record that is played shows what was shown: in sequence, from any step, backwards, whatever the threads.
#include <limits>

#include "tests/api/record_fixture.h"

namespace
{

using records::Bytes;
using records::Player;
using records::Recording;
using records::Shown;

clq_context_def with_threads(records::Threads &threads)
{
    clq_context_def def = clq_context_def_init();
    if (threads.count > 1) def.tasks = {&threads, records::Threads::run};
    return def;
}

class Records : public testing::Test
{
protected:
    static constexpr uint32_t steps = 240;
    TestWorld world_;
};

TEST_F(Records, PlayedInSequenceShowWhatWasShown)
{
    for (const uint64_t seed : {1, 2, 3}) {
        const Recording run = records::run(world_, steps, seed);
        Player player(world_, run.bytes);
        ASSERT_TRUE(player.opened()) << clq_last_error();
        Shown seen;
        for (uint32_t step = 0; step < steps; ++step) player.show(step, seen);
        EXPECT_EQ(seen, run.shown) << "seed " << seed;
        ASSERT_EQ(clq_record_play_step(player.record, player.crowd, steps), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_crowd_get_hash(player.crowd), run.last_hash) << "the call after the last update";
        EXPECT_GE(run.info.key_states, 2u);
        EXPECT_EQ(player.info().state_count, run.info.key_states + 2) << "the first one and the restored one";
    }
}

TEST_F(Records, ShowAnyStepByItselfAsInSequence)
{
    const Recording run = records::run(world_, steps, 4);
    Player player(world_, run.bytes);
    for (uint32_t take = 0; take < 3 * steps; ++take) {
        // At random, backwards, and in small jumps.
        const uint32_t step = take < steps       ? static_cast<uint32_t>(mixed(7, take) % steps)
                              : take < 2 * steps ? 2 * steps - 1 - take
                                                 : (take * 7) % steps;
        Shown seen;
        player.show(step, seen);
        ASSERT_EQ(seen.lists[0], run.shown.lists[step]) << "step " << step;
        ASSERT_EQ(seen.crowds[0], run.shown.crowds[step]) << "step " << step;
    }
    for (uint32_t step = 0; step < steps; step += 17) {
        Player fresh(world_, run.bytes);
        Shown seen;
        fresh.show(step, seen);
        EXPECT_EQ(seen.lists[0], run.shown.lists[step]) << "step " << step;
    }
}

TEST(RecordedRuns, AreTheSameBytesAndListsWhateverTheThreads)
{
    Recording first;
    for (const uint32_t count : {1u, 2u, 4u}) {
        records::Threads threads{count};
        const clq_context_def context = with_threads(threads);
        TestWorld world(&context);
        const Recording run = records::run(world, 60, 5);
        if (count == 1) first = run;
        EXPECT_EQ(run.bytes, first.bytes) << count << " threads";
        EXPECT_EQ(run.shown, first.shown) << count << " threads";
        Player player(world, first.bytes);
        Shown seen;
        for (uint32_t step = 0; step < 60; ++step) player.show(step, seen);
        EXPECT_EQ(seen, first.shown) << count << " threads";
    }
}

TEST_F(Records, ChangeNothingOfTheRecordedCrowd)
{
    const Recording run = records::run(world_, 40, 6);
    const uint64_t none = std::numeric_limits<uint64_t>::max();
    const Recording few = records::run(world_, 40, 6, none);
    EXPECT_EQ(few.shown, run.shown);
    EXPECT_EQ(few.info.key_states, 0u);
    EXPECT_LT(few.bytes.size(), run.bytes.size());
}

TEST_F(Records, SaveAndRestoreWorkInsideThem)
{
    const Recording run = records::run(world_, steps, 8);
    Player player(world_, run.bytes), other(world_, run.bytes);
    Shown seen;
    player.show(70, seen);
    const Bytes saved = saved::save(player.crowd);
    // Into another crowd, which then goes on by itself.
    ASSERT_EQ(clq_crowd_restore(other.crowd, saved.data(), saved.size(), world_.templates, 2), CLQ_ARGUMENT)
        << "its host mechanism is not there yet";
    other.show(0, seen);
    ASSERT_EQ(clq_crowd_restore(other.crowd, saved.data(), saved.size(), world_.templates, 2), CLQ_OK)
        << clq_last_error();
    ASSERT_EQ(clq_crowd_update(other.crowd, run.shown.times[70], &other.view, 1), CLQ_OK);
    EXPECT_EQ(clq_view_get_hash(other.view), run.shown.lists[70]);
    // And the record goes on where the host leaves it.
    seen = {};
    other.show(71, seen);
    EXPECT_EQ(seen.lists[0], run.shown.lists[71]);
}

TEST_F(Records, TakeBackWhatTheHostChangesInAPlayedCrowd)
{
    const Recording run = records::run(world_, 40, 9);
    Player player(world_, run.bytes);
    Shown seen;
    player.show(20, seen);
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = world_.templates[1];
    clq_actor guest;
    ASSERT_EQ(clq_actor_create(player.crowd, &def, &guest), CLQ_OK);
    player.show(21, seen);
    EXPECT_EQ(seen.crowds[1], run.shown.crowds[21]);
    EXPECT_EQ(seen.lists[1], run.shown.lists[21]);
}

TEST_F(Records, DoNotGoOnWhereAnotherOneWas)
{
    const Recording one = records::run(world_, 40, 21), other = records::run(world_, 40, 22);
    Player first(world_, one.bytes), second(world_, other.bytes);
    Shown seen;
    for (uint32_t step = 3; step < 40; step += 5) {
        first.show(step, seen);
        ASSERT_EQ(clq_record_play_step(second.record, first.crowd, step + 1), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_crowd_get_hash(first.crowd), other.shown.crowds[step + 1]) << step;
        // And two crowds play one record, each at its place.
        ASSERT_EQ(clq_record_play_step(second.record, second.crowd, 39 - step), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_crowd_get_hash(second.crowd), other.shown.crowds[39 - step]) << step;
    }
}

}  // namespace
