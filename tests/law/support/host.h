// A host's services for tests: memory that counts and can refuse, and tasks on threads.
#pragma once

#include <atomic>
#include <thread>
#include <vector>

#include "lib/base/services.h"

namespace claque::testing_support
{

// Counts the held memory; refuses the n-th allocation from now on, once.
class CountingMemory : public std::pmr::memory_resource
{
public:
    void refuse_nth(uint64_t n) { refuse_in_ = n; }  // 0: refuse nothing
    void refuse_all(bool refuse) { refuse_all_ = refuse; }
    void refuse_from(std::size_t bytes) { refuse_from_ = bytes; }  // in one piece; 0: refuse nothing
    uint64_t allocations() const { return allocations_; }
    int64_t bytes() const { return bytes_; }
    bool refused() const { return refused_; }
    void forget() { refused_ = false, refuse_in_ = 0; }

private:
    void *do_allocate(std::size_t bytes, std::size_t alignment) override
    {
        ++allocations_;
        if (refuse_all_ || (refuse_from_ != 0 && bytes >= refuse_from_) || (refuse_in_ && --refuse_in_ == 0)) {
            refused_ = true;
            throw std::bad_alloc();
        }
        bytes_ += int64_t(bytes);
        return std::pmr::new_delete_resource()->allocate(bytes, alignment);
    }
    void do_deallocate(void *memory, std::size_t bytes, std::size_t alignment) override
    {
        bytes_ -= int64_t(bytes);
        std::pmr::new_delete_resource()->deallocate(memory, bytes, alignment);
    }
    bool do_is_equal(const std::pmr::memory_resource &other) const noexcept override { return this == &other; }

    uint64_t allocations_ = 0, refuse_in_ = 0;
    std::size_t refuse_from_ = 0;
    int64_t bytes_ = 0;
    bool refused_ = false, refuse_all_ = false;
};

// Runs tasks from a common counter on `count` threads, in any order.
class Threads
{
public:
    explicit Threads(uint32_t count) : count_(count) {}
    base::Jobs jobs() { return base::Jobs(clq_tasks{this, &Threads::run}); }

private:
    static void run(void *user, uint32_t count, void (*job)(void *, uint32_t), void *data)
    {
        std::atomic<uint32_t> next{0};
        const auto work = [&] {
            for (uint32_t i = next++; i < count; i = next++)
                job(data, count - 1 - i);  // a different order from that on one thread
        };
        std::vector<std::thread> threads;
        for (uint32_t i = 1; i < static_cast<Threads *>(user)->count_; ++i) threads.emplace_back(work);
        work();
        for (std::thread &thread : threads) thread.join();
    }
    uint32_t count_;
};

}  // namespace claque::testing_support
