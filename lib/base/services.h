// The host's services: memory, log, tasks. One per clq_context, used by all its objects. An exception of their
// callbacks ends here.
#pragma once

#include <claque/base.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory_resource>
#include <vector>

#include "lib/base/floats.h"

namespace claque::base
{

// The host's allocator as a std::pmr resource; a refusal throws std::bad_alloc, and an exception counts as a refusal.
class HostMemory : public std::pmr::memory_resource
{
public:
    explicit HostMemory(const clq_allocator &allocator) : allocator_(allocator) {}

private:
    void *do_allocate(std::size_t bytes, std::size_t alignment) override;
    void do_deallocate(void *memory, std::size_t bytes, std::size_t alignment) noexcept override;
    bool do_is_equal(const std::pmr::memory_resource &other) const noexcept override { return this == &other; }

    clq_allocator allocator_;
};

// The same two calls without a resource.
void *allocate_from(const clq_allocator &allocator, std::size_t bytes, std::size_t alignment);
void release_to(const clq_allocator &allocator, void *memory, std::size_t bytes, std::size_t alignment) noexcept;

// Exceptions of the host's log are dropped: there is no better place to report them.
struct Log {
    clq_log host{};
    void warn(const char *text) const noexcept { write(CLQ_LOG_WARNING, text); }
    void info(const char *text) const noexcept { write(CLQ_LOG_INFO, text); }
    void write(clq_log_level level, const char *text) const noexcept;
};

// Which tasks of a loop have begun, so that each runs once.
class TaskClaims
{
public:
    static constexpr uint32_t max_tasks = 4096;
    bool claim(uint32_t task) noexcept
    {
        const uint32_t bit = uint32_t(1) << (task % 32);
        return !(begun_[task / 32].fetch_or(bit, std::memory_order_relaxed) & bit);
    }

private:
    std::atomic<uint32_t> begun_[max_tasks / 32]{};
};

// Runs a loop as the host's tasks, or on this thread. The order of indices is unspecified. Calls that the host's tasks
// leave out, because they threw, are made on this thread.
class Jobs
{
public:
    Jobs() = default;
    explicit Jobs(const clq_tasks &tasks, const Log &log = {}) : tasks_(tasks), log_(log) {}

    // The body must not throw.
    template <class Body>
    void for_each(uint32_t count, const Body &body) const
    {
        if (!tasks_.run || count < 2) {
            for (uint32_t i = 0; i < count; ++i) body(i);
            return;
        }
        Batch<Body> batch{body, count, std::min(count, TaskClaims::max_tasks), {}};
        run_host_tasks(batch.tasks, Batch<Body>::run, &batch);
        for (uint32_t task = 0; task < batch.tasks; ++task) Batch<Body>::run(&batch, task);
    }

    // For start-up code, whose body may throw: rethrows the exception of the lowest index, so that it does not depend
    // on threads. The body may then have run or not for any other index.
    template <class Body>
    void try_each(uint32_t count, const Body &body) const
    {
        if (!tasks_.run || count < 2) {
            for (uint32_t i = 0; i < count; ++i) body(i);
            return;
        }
        std::vector<std::exception_ptr> thrown(count);
        for_each(count, [&](uint32_t i) {
            try {
                body(i);
            } catch (...) {
                thrown[i] = std::current_exception();
            }
        });
        for (const std::exception_ptr &one : thrown)
            if (one) std::rethrow_exception(one);
    }

private:
    // A loop cut into tasks of neighbouring indices; up to max_tasks they are one index each.
    template <class Body>
    struct Batch {
        const Body &body;
        uint32_t count, tasks;
        TaskClaims claims;

        static void run(void *data, uint32_t task)
        {
            Batch &batch = *static_cast<Batch *>(data);
            if (task >= batch.tasks || !batch.claims.claim(task)) return;
            with_own_floats([&] { batch.run_task(task); });
        }

        void run_task(uint32_t task) const
        {
            const uint32_t last = static_cast<uint32_t>(uint64_t(count) * (task + 1) / tasks);
            for (uint32_t i = static_cast<uint32_t>(uint64_t(count) * task / tasks); i < last; ++i) body(i);
        }
    };

    // Warns of an exception.
    void run_host_tasks(uint32_t count, void (*job)(void *, uint32_t), void *job_data) const noexcept;

    clq_tasks tasks_{};
    Log log_;
};

}  // namespace claque::base
