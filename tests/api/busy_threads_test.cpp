// The threads that each call documents, side by side: each call succeeds or is BUSY, and no memory is read while it is
// written. To be run under a thread sanitizer as well.
#include <atomic>
#include <thread>

#include "tests/api/busy_calls.h"
#include "tests/api/stub_gl.h"

namespace
{

using busy::Call;
using busy::Use;

bool ends(const Call &call)
{
    return call.name.find("destroy") != std::string::npos || call.name.find("abandon") != std::string::npos;
}

// Those that the writer makes again and again: not those that end what the others use.
bool repeats(const Call &call)
{
    return call.use == Use::changes_crowd && !ends(call) && call.name != "clq_crowd_restore" &&
           call.name.find("_add_") == std::string::npos && call.name != "clq_view_create" &&
           call.name != "clq_scene_create";
}

struct Tried {
    uint32_t done = 0, busy = 0;
};

using BusyThreads = busy::Busy;

TEST_F(BusyThreads, ReadersAndDrawersRunBesideTheWriterAndNeverRace)
{
    constexpr uint32_t reader_count = 2, rounds = 30;
    std::atomic<bool> stop{false};
    std::vector<std::thread> threads;
    std::vector<Tried> tried(reader_count + 1);
    std::atomic<uint32_t> ready{0};
    const auto work = [&](uint32_t k, Use first, Use second) {
        bool counted = false;
        while (!stop)
            for (const Call &call : busy::calls()) {
                if ((call.use != first && call.use != second) || ends(call)) continue;
                const clq_status status = call.run(objects_);
                // the writer may have destroyed the actor's twin or emptied the list, never the actor itself
                EXPECT_TRUE(status == CLQ_OK || status == CLQ_BUSY || status == CLQ_ARGUMENT)
                    << call.name << ": " << clq_status_name(status);
                ++(status == CLQ_OK ? tried[k].done : tried[k].busy);
                if (!counted && tried[k].done > 200) counted = true, ++ready;
                std::this_thread::yield();
            }
    };
    for (uint32_t k = 0; k < reader_count; ++k) threads.emplace_back(work, k, Use::reads_crowd, Use::reads_view);
    threads.emplace_back(work, reader_count, Use::renders, Use::renders);
    Tried written;
    for (uint32_t round = 0; round < rounds || ready < reader_count + 1; ++round) {
        for (const Call &call : busy::calls()) {
            if (!repeats(call)) continue;
            const clq_status status = call.run(objects_);
            ++(status == CLQ_BUSY ? written.busy : written.done);
        }
        ++(clq_crowd_update(objects_.crowd, 1 + 0.01 * round, &objects_.view, 1) == CLQ_OK ? written.done
                                                                                           : written.busy);
        std::this_thread::yield();
    }
    stop = true;
    for (std::thread &thread : threads) thread.join();
    EXPECT_GT(written.done, rounds);
    for (const Tried &one : tried) EXPECT_GT(one.done, 200u);
}

// A crowd's writer may change; where two meet, one is told.
TEST_F(BusyThreads, WritersOnSeveralThreadsAreDoneOneAtATimeOrBusy)
{
    constexpr uint32_t writer_count = 3;
    std::atomic<uint32_t> done{0}, updates{0};
    std::vector<std::thread> threads;
    for (uint32_t k = 0; k < writer_count; ++k)
        threads.emplace_back([&, k] {
            for (uint32_t round = 0; round < 20; ++round) {
                for (const Call &call : busy::calls())
                    if (repeats(call)) done += call.run(objects_) != CLQ_BUSY;
                const double time_s = 1 + 0.01 * round + 0.001 * k;
                const clq_status status = clq_crowd_update(objects_.crowd, time_s, &objects_.view, 1);
                EXPECT_TRUE(status == CLQ_OK || status == CLQ_BUSY) << clq_last_error();
                updates += status == CLQ_OK;
                std::this_thread::yield();
            }
        });
    for (std::thread &thread : threads) thread.join();
    EXPECT_GT(done, 0u);
    EXPECT_GT(updates, 0u);
    EXPECT_EQ(clq_crowd_update(objects_.crowd, 2, &objects_.view, 1), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_renderer_draw(objects_.renderer, objects_.view, nullptr), CLQ_OK) << clq_last_error();
}

TEST_F(BusyThreads, CrowdsOfOneContextAreMadeUsedAndEndedOnThreadsOfTheirOwn)
{
    std::vector<std::thread> threads;
    for (uint32_t k = 0; k < 3; ++k)
        threads.emplace_back([&, k] {
            for (uint32_t round = 0; round < 5; ++round) {
                clq_crowd *crowd = nullptr;
                ASSERT_EQ(clq_crowd_create(world_.context, nullptr, &crowd), CLQ_OK);
                clq_actor_def def = clq_actor_def_init();
                def.tmpl = world_.templates[k % 2];
                def.transform.position[2] = -5;
                clq_actor actor;
                ASSERT_EQ(clq_actor_create(crowd, &def, &actor), CLQ_OK);
                clq_view *view = world_.new_view(crowd, 0);
                ASSERT_EQ(clq_crowd_update(crowd, 1, &view, 1), CLQ_OK);
                EXPECT_NE(clq_view_get_hash(view), 0u);
                EXPECT_EQ(clq_view_destroy(view), CLQ_OK);
                EXPECT_EQ(clq_crowd_destroy(crowd), CLQ_OK);
            }
        });
    for (std::thread &thread : threads) thread.join();
}

}  // namespace
