#include "samples/scenes/tasks_tbb.h"

#include <atomic>
#include <thread>
#include <vector>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace scenes
{

using Job = void (*)(void *, uint32_t);

#ifdef __SANITIZE_THREAD__
// ThreadSanitizer does not see into the packaged oneTBB: it would report all that only oneTBB keeps in order.
struct TbbTasks::Arena {
    explicit Arena(int of_threads) : threads(of_threads) {}

    void run(uint32_t count, Job job, void *job_data) const
    {
        std::atomic<uint32_t> next{0};
        const auto work = [&] {
            for (uint32_t i = next++; i < count; i = next++) job(job_data, i);
        };
        std::vector<std::thread> others;
        for (int i = 1; i < threads; ++i) others.emplace_back(work);
        work();
        for (std::thread &other : others) other.join();
    }

    int threads;
};
#else
struct TbbTasks::Arena {
    explicit Arena(int threads)
        : control(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(threads)), arena(threads)
    {
    }
    // Waits for the workers to end before the program ends: threads that are still exiting confuse leak checkers.
    ~Arena()
    {
        arena.terminate();
        tbb::finalize(scheduler, std::nothrow);
    }

    void run(uint32_t count, Job job, void *job_data)
    {
        arena.execute([&] {
            // One task each: claque has already cut its work into pieces of that size.
            tbb::parallel_for(
                tbb::blocked_range<uint32_t>(0, count, 1),
                [&](const tbb::blocked_range<uint32_t> &range) {
                    for (uint32_t i = range.begin(); i != range.end(); ++i) job(job_data, i);
                },
                tbb::simple_partitioner());
        });
    }

    tbb::task_scheduler_handle scheduler{tbb::attach{}};
    tbb::global_control control;
    tbb::task_arena arena;
};
#endif

TbbTasks::TbbTasks(int threads) : arena_(threads > 1 ? std::make_unique<Arena>(threads) : nullptr) {}
TbbTasks::~TbbTasks() = default;

clq_tasks TbbTasks::hook()
{
    clq_tasks hook = {};
    if (!arena_) return hook;
    hook.user = arena_.get();
    hook.run = [](void *user, uint32_t count, Job job, void *job_data) {
        static_cast<Arena *>(user)->run(count, job, job_data);
    };
    return hook;
}

}  // namespace scenes
