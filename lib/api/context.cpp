#include <claque/context.h>

#include <cstddef>
#include <cstdlib>
#ifdef _WIN32
#include <malloc.h>
#endif

#include "lib/api/boundary.h"
#include "lib/api/handles.h"

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
        void *memory = allocator.allocate(allocator.user, sizeof(clq_context), alignof(clq_context));
        if (!memory) throw std::bad_alloc();
        *out = new (memory) clq_context(allocator, wanted.log, wanted.tasks);
    });
}

clq_status clq_context_destroy(clq_context *context)
{
    return api::boundary("clq_context_destroy", [&] {
        if (!context) return;
        const uint32_t children = context->children;
        if (children) base::fail(CLQ_IN_USE, "%u templates, crowds or renderers made from it still exist", children);
        const clq_allocator allocator = context->allocator;
        context->~clq_context();
        allocator.release(allocator.user, context, sizeof(clq_context), alignof(clq_context));
    });
}

void clq_context_log(clq_context *context, clq_log_level level, const char *text)
{
    if (context && text && context->log.host.write) context->log.host.write(context->log.host.user, level, text);
}

void clq_context_run(clq_context *context, uint32_t count, void (*job)(void *job_data, uint32_t index), void *job_data)
{
    const base::Jobs jobs = context ? context->jobs : base::Jobs();
    if (job) jobs.for_each(count, [&](uint32_t i) { job(job_data, i); });
}

}  // extern "C"
