#include "lib/base/services.h"

#include <new>

#include "lib/base/host_call.h"

namespace claque::base
{

void *allocate_from(const clq_allocator &allocator, std::size_t bytes, std::size_t alignment)
{
    void *memory = nullptr;
    call_host("allocate", [&] { memory = allocator.allocate(allocator.user, bytes, alignment); });
    if (!memory) throw std::bad_alloc();
    return memory;
}

void release_to(const clq_allocator &allocator, void *memory, std::size_t bytes, std::size_t alignment) noexcept
{
    call_host("release", [&] { allocator.release(allocator.user, memory, bytes, alignment); });
}

void *HostMemory::do_allocate(std::size_t bytes, std::size_t alignment)
{
    return allocate_from(allocator_, bytes, alignment);
}

void HostMemory::do_deallocate(void *memory, std::size_t bytes, std::size_t alignment) noexcept
{
    release_to(allocator_, memory, bytes, alignment);
}

void Log::write(clq_log_level level, const char *text) const noexcept
{
    if (host.write) call_host("log.write", [&] { host.write(host.user, level, text); });
}

void Jobs::run_host_tasks(uint32_t count, void (*job)(void *, uint32_t), void *job_data) const noexcept
{
    const Status status =
        call_host("clq_context_def.tasks.run", [&] { tasks_.run(tasks_.user, count, job, job_data); });
    if (status.ok()) return;
    char text[360];
    std::snprintf(text, sizeof text, "%s; the calls that it left out were made on the calling thread", status.text);
    log_.warn(text);
}

}  // namespace claque::base
