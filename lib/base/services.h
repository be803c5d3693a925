// The host's services: memory, log, tasks. One per clq_context, used by all its objects.
#pragma once

#include <claque/base.h>

#include <exception>
#include <memory_resource>
#include <vector>

namespace claque::base
{

// The host's allocator as a std::pmr resource; a refusal throws std::bad_alloc.
class HostMemory : public std::pmr::memory_resource
{
public:
    explicit HostMemory(const clq_allocator &allocator) : allocator_(allocator) {}

private:
    void *do_allocate(std::size_t bytes, std::size_t alignment) override;
    void do_deallocate(void *memory, std::size_t bytes, std::size_t alignment) override;
    bool do_is_equal(const std::pmr::memory_resource &other) const noexcept override { return this == &other; }

    clq_allocator allocator_;
};

// Runs a loop as the host's tasks, or on this thread. The order of indices is unspecified.
class Jobs
{
public:
    Jobs() = default;
    explicit Jobs(const clq_tasks &tasks) : tasks_(tasks) {}

    // The body must not throw.
    template <class Body>
    void for_each(uint32_t count, const Body &body) const
    {
        if (!tasks_.run || count < 2) {
            for (uint32_t i = 0; i < count; ++i) body(i);
            return;
        }
        tasks_.run(
            tasks_.user, count, [](void *data, uint32_t i) { (*static_cast<const Body *>(data))(i); },
            const_cast<Body *>(&body));
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
    clq_tasks tasks_{};
};

struct Log {
    clq_log host{};
    void warn(const char *text) const
    {
        if (host.write) host.write(host.user, CLQ_LOG_WARNING, text);
    }
    void info(const char *text) const
    {
        if (host.write) host.write(host.user, CLQ_LOG_INFO, text);
    }
};

}  // namespace claque::base
