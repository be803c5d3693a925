// The structs behind the opaque handles of templates and contexts.
#pragma once

#include <claque/context.h>
#include <claque/template.h>

#include <atomic>
#include <utility>

#include "lib/base/services.h"
#include "lib/model/template.h"

struct clq_context {
    clq_context(const clq_allocator &host, const clq_log &host_log, const clq_tasks &tasks)
        : allocator(host), memory(host), jobs(tasks, {host_log}), log{host_log}
    {
    }
    clq_allocator allocator;
    claque::base::HostMemory memory;
    claque::base::Jobs jobs;
    claque::base::Log log;
    std::atomic<uint32_t> children{0};  // objects made from it that still exist
};

// A split character with a reference count: one for the host, one for each crowd and renderer that uses it.
struct clq_template : claque::model::Template {
    explicit clq_template(clq_context *owner) : Template(&owner->memory), context(owner) {}
    clq_context *context;
    std::atomic<uint32_t> holders{1};
};

namespace claque::api
{

// A handle in the context's memory, destroyed with it unless released, so that a failed construction leaks nothing.
template <class Handle, class... Arguments>
Handle *make(clq_context *context, Arguments &&...arguments)
{
    void *memory = context->memory.allocate(sizeof(Handle), alignof(Handle));
    try {
        Handle *handle = new (memory) Handle(std::forward<Arguments>(arguments)...);
        ++context->children;
        return handle;
    } catch (...) {
        context->memory.deallocate(memory, sizeof(Handle), alignof(Handle));
        throw;
    }
}

template <class Handle>
void unmake(clq_context *context, Handle *handle)
{
    handle->~Handle();
    context->memory.deallocate(handle, sizeof(Handle), alignof(Handle));
    --context->children;
}

// Owns a handle until `release`.
template <class Handle>
class Making
{
public:
    template <class... Arguments>
    explicit Making(clq_context *context, Arguments &&...arguments)
        : context_(context), handle_(make<Handle>(context, std::forward<Arguments>(arguments)...))
    {
    }
    Making(const Making &) = delete;
    Making &operator=(const Making &) = delete;
    ~Making()
    {
        if (handle_) unmake(context_, handle_);
    }
    Handle *operator->() const { return handle_; }
    Handle &operator*() const { return *handle_; }
    Handle *release() { return std::exchange(handle_, nullptr); }

private:
    clq_context *context_;
    Handle *handle_;
};

inline void hold(clq_template *tmpl) { ++tmpl->holders; }

inline void release(clq_template *tmpl)
{
    if (--tmpl->holders == 0) unmake(tmpl->context, tmpl);
}

}  // namespace claque::api
