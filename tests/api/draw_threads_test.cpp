// Drawing on one thread while another updates: each call succeeds or returns CLQ_BUSY, and no memory is read while it
// is written.
#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "tests/api/stub_gl.h"

namespace
{

struct Tried {
    uint32_t done = 0, busy = 0;
    // Whether the view was drawn.
    bool note(clq_status status)
    {
        EXPECT_TRUE(status == CLQ_OK || status == CLQ_BUSY) << clq_last_error();
        ++(status == CLQ_OK ? done : busy);
        return status == CLQ_OK;
    }
};

// Threads draw views of one crowd while this one updates it.
void draw_while_updating(const clq_crowd_def &def)
{
    TestWorld test_world;
    clq_crowd *crowd = test_world.new_crowd(&def);
    test_world.set_up(crowd);
    test_world.fill(crowd, 200, 5);
    constexpr uint32_t drawers = 3;
    clq_view *views[drawers];
    clq_renderer *renderers[drawers];
    for (uint32_t k = 0; k < drawers; ++k) {
        views[k] = test_world.new_view(crowd, 3.0 * k);
        renderers[k] = stub_gl::new_renderer(test_world);
    }
    ASSERT_EQ(clq_crowd_update(crowd, 1, views, drawers), CLQ_OK) << clq_last_error();
    std::atomic<bool> stop{false};
    std::atomic<uint32_t> ready{0};
    Tried drawn[drawers], updated;
    uint64_t individuals[drawers] = {};
    std::vector<std::thread> threads;
    for (uint32_t k = 0; k < drawers; ++k)
        threads.emplace_back([&, k] {
            while (!stop && !::testing::Test::HasFailure()) {
                clq_draw_stats stats = clq_draw_stats_init();
                if (drawn[k].note(clq_renderer_draw(renderers[k], views[k], &stats)) && drawn[k].done == 5) ++ready;
                individuals[k] += stats.individuals;
                std::this_thread::yield();
            }
        });
    // Until each thread has drawn and some updates have run between draws.
    while (!::testing::Test::HasFailure() && (updated.done < 20 || ready < drawers)) {
        updated.note(clq_crowd_update(crowd, 1 + 0.01 * updated.done, views, drawers));
        std::this_thread::yield();
    }
    stop = true;
    for (std::thread &thread : threads) thread.join();
    EXPECT_GE(updated.done, 20u);
    for (uint32_t k = 0; k < drawers; ++k) {
        EXPECT_GE(drawn[k].done, 5u);
        EXPECT_GT(individuals[k], 0u);
        clq_renderer_destroy(renderers[k]);
    }
}

}  // namespace

TEST(DrawThreads, DrawsAndUpdatesAreDoneOrBusyAndNeverARace)
{
    for (const clq_vertex_format geometry : {CLQ_VERTEX_FLOAT, CLQ_VERTEX_PACKED})
        // with the second budget the draws skin much of the crowd
        for (const uint64_t budget : {uint64_t(0), uint64_t(20000)}) {
            clq_crowd_def def = clq_crowd_def_init();
            def.vertex_format = geometry;
            def.cache_budget_bytes = budget;
            draw_while_updating(def);
        }
}

TEST(DrawThreads, HooksThatUpdateGetBusyAndADrawnViewCannotBeUsedElsewhere)
{
    TestWorld test_world;
    clq_crowd *crowd = test_world.new_crowd();
    test_world.set_up(crowd);
    std::vector<clq_actor> actors = test_world.fill(crowd, 30, 5);
    clq_view *view = test_world.new_view(crowd, 0), *other = test_world.new_view(crowd, 4);
    struct Asked {
        clq_crowd *crowd;
        clq_view *view, *other;
        clq_status update = CLQ_OK, same = CLQ_OK, beside = CLQ_BUSY;
        uint32_t calls = 0;
    } asked = {crowd, view, other};
    clq_actor_hooks hooks = {};
    hooks.before = [](void *user, clq_actor) {
        Asked &a = *static_cast<Asked *>(user);
        clq_view_stats stats = clq_view_stats_init();
        a.update = clq_crowd_update(a.crowd, 9, &a.view, 1);
        a.same = clq_view_get_stats(a.view, &stats);
        a.beside = clq_view_get_stats(a.other, &stats);
        ++a.calls;
        return false;
    };
    hooks.user = &asked;
    for (const clq_actor actor : actors) ASSERT_EQ(clq_actor_set_hooks(crowd, actor, &hooks), CLQ_OK);
    clq_view *views[] = {view, other};
    ASSERT_EQ(clq_crowd_update(crowd, 1, views, 2), CLQ_OK) << clq_last_error();
    clq_renderer *renderer = stub_gl::new_renderer(test_world);
    EXPECT_EQ(clq_renderer_draw(renderer, view, nullptr), CLQ_OK) << clq_last_error();
    EXPECT_GT(asked.calls, 0u);
    EXPECT_EQ(asked.update, CLQ_BUSY);
    EXPECT_EQ(asked.same, CLQ_BUSY);
    EXPECT_EQ(asked.beside, CLQ_OK);
    EXPECT_EQ(clq_crowd_update(crowd, 2, views, 2), CLQ_OK) << clq_last_error();
    clq_renderer_destroy(renderer);
}
