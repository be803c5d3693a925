// Updates on a host's threads show what updates on one thread show, and two threads never touch the same data; to be
// run under a thread sanitizer as well.
#include <atomic>
#include <thread>

#include "tests/api/saved_bytes.h"
#include "tests/api/test_world.h"

namespace
{

constexpr uint32_t thread_count = 4;

// Threads take indices from a common counter, the last ones first.
void run_tasks_on_threads(void *user, uint32_t count, void (*job)(void *job_data, uint32_t index), void *job_data)
{
    static_cast<std::atomic<uint64_t> *>(user)->fetch_add(count);
    std::atomic<uint32_t> next{0};
    const auto work = [&] {
        for (uint32_t i = next++; i < count; i = next++) job(job_data, count - 1 - i);
    };
    std::vector<std::thread> threads;
    for (uint32_t i = 1; i < thread_count; ++i) threads.emplace_back(work);
    work();
    for (std::thread &thread : threads) thread.join();
}

// The hashes of two views over a run with mechanisms, groups, paths and a restored state.
std::vector<uint64_t> shown(const clq_context_def *context, clq_cache_mode cache, uint32_t last_mechanism)
{
    TestWorld test_world(context);
    clq_crowd_def def = clq_crowd_def_init();
    def.cache = cache;
    clq_crowd *crowd = test_world.new_crowd(&def);
    test_world.set_up(crowd);
    std::vector<clq_actor> actors = test_world.fill(crowd, 300, 5);
    for (const clq_actor actor : actors)
        for (uint32_t kind = last_mechanism; kind < 6; ++kind) clq_actor_detach_mechanism(crowd, actor, {kind + 1});
    clq_view *views[2] = {test_world.new_view(crowd, -3), test_world.new_view(crowd, 9)};
    std::vector<uint64_t> out;
    saved::Bytes bytes;
    std::vector<clq_actor> actors_then;
    for (uint32_t frame = 0; frame < 24; ++frame) {
        test_world.happen(crowd, actors, 6, frame);
        if (frame == 8) bytes = saved::save(crowd), actors_then = actors;
        if (frame == 16) {
            EXPECT_EQ(clq_crowd_restore(crowd, bytes.data(), bytes.size(), test_world.templates, 2), CLQ_OK)
                << clq_last_error();
            actors = actors_then;
        }
        EXPECT_EQ(clq_crowd_update(crowd, 2 + 0.04 * frame, views, 2), CLQ_OK) << clq_last_error();
        for (clq_view *view : views) out.push_back(clq_view_get_hash(view));
    }
    return out;
}

}  // namespace

TEST(Threads, ShowWhatOneThreadShows)
{
    std::atomic<uint64_t> tasks{0};
    clq_context_def threaded = clq_context_def_init();
    threaded.tasks = {&tasks, run_tasks_on_threads};
    for (const clq_cache_mode cache : {CLQ_CACHE_FULL, CLQ_CACHE_ANIMATION, CLQ_CACHE_NONE})
        for (const uint32_t last :
             {5u, 6u})  // without the host's mechanism, which keeps behaviour on one thread; and with it
            EXPECT_EQ(shown(&threaded, cache, last), shown(nullptr, cache, last)) << cache << " " << last;
    EXPECT_GT(tasks, 1000u);
}
