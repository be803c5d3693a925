// The services of the host: allocator, log and tasks.
#include <claque/context.h>

#include <cstddef>
#include <cstdlib>
#include <mutex>
#ifdef _WIN32
#include <malloc.h>
#endif

#include "lib/api/boundary.h"
#include "lib/api/handles.h"
#include "lib/base/host_call.h"

using namespace claque;

namespace
{

void *default_allocate(void *, size_t size_bytes, size_t alignment_bytes)
{
    if (alignment_bytes <= alignof(std::max_align_t)) return std::malloc(size_bytes ? size_bytes : 1);
    const size_t rounded = (size_bytes + alignment_bytes - 1) / alignment_bytes * alignment_bytes;
#ifdef _WIN32
    return _aligned_malloc(rounded, alignment_bytes);
#else
    return std::aligned_alloc(alignment_bytes, rounded);
#endif
}

void default_release(void *, void *memory, size_t, [[maybe_unused]] size_t alignment_bytes)
{
#ifdef _WIN32
    if (alignment_bytes > alignof(std::max_align_t)) return _aligned_free(memory);
#endif
    std::free(memory);
}

// The failed job of the lowest index, so that the report does not depend on threads.
class FirstFailure
{
public:
    void note(uint32_t index, const base::Status &status)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (index >= index_) return;
        index_ = index;
        status_ = status;
    }
    void report() const
    {
        if (!status_.ok()) base::fail(status_.code, "at index %u %s", index_, status_.text);
    }

private:
    std::mutex mutex_;
    uint32_t index_ = CLQ_NONE;
    base::Status status_;
};

}  // namespace

extern "C" {

clq_status clq_context_create(const clq_context_def *def, clq_context **out)
{
    return api::boundary("clq_context_create", [&] {
        api::require(out != nullptr, "out is NULL");
        const clq_context_def wanted = api::read_def(def, clq_context_def_init, "clq_context_def_init");
        clq_allocator allocator = wanted.allocator;
        api::require((allocator.allocate == nullptr) == (allocator.release == nullptr),
                     "the allocator has only one of allocate and release");
        if (!allocator.allocate) allocator = {nullptr, default_allocate, default_release};
        void *memory = base::allocate_from(allocator, sizeof(clq_context), alignof(clq_context));
        *out = new (memory) clq_context(allocator, wanted.log, wanted.tasks);
    });
}

clq_status clq_context_destroy(clq_context *context)
{
    return api::boundary("clq_context_destroy", [&] {
        if (!context) return;
        const uint32_t children = context->children;
        if (children)
            base::fail(
                CLQ_IN_USE,
                "%u templates, locomotions, tracks, crowds, records, colour maps or renderers made from it still exist",
                children);
        const clq_allocator allocator = context->allocator;
        context->~clq_context();
        base::release_to(allocator, context, sizeof(clq_context), alignof(clq_context));
    });
}

void clq_context_log(clq_context *context, clq_log_level level, const char *text)
{
    if (context && text) context->log.write(level, text);
}

clq_status clq_context_run(clq_context *context, uint32_t count, void (*job)(void *job_data, uint32_t index),
                           void *job_data)
{
    return api::boundary("clq_context_run", [&] {
        if (!job) return;
        const base::Jobs jobs = context ? context->jobs : base::Jobs();
        FirstFailure failure;
        jobs.for_each(count, [&](uint32_t i) {
            const base::Status status = base::call_host("the job", [&] { job(job_data, i); });
            if (!status.ok()) failure.note(i, status);
        });
        failure.report();
    });
}

}  // extern "C"
