// The struct behind clq_renderer.
#pragma once

#include <claque/renderer.h>

#include "lib/api/handles.h"
#include "lib/base/error.h"
#include "passes/renderer.h"

struct clq_renderer {
    clq_renderer(clq_context *owner, const claque::passes::RendererOptions &options)
        : context(owner), requested(options.strategy), renderer(&owner->memory, options), held(&owner->memory)
    {
    }
    clq_context *context;
    claque::passes::Strategy requested;
    claque::passes::Renderer renderer;
    std::pmr::vector<clq_template *> held;  // every template it was prepared for
    mutable std::atomic<bool> at_work{false};
};

namespace claque::api
{

// Locks a renderer for the length of a call; a hook that uses the renderer that calls it gets CLQ_BUSY.
class Rendering
{
public:
    explicit Rendering(const clq_renderer *renderer) : renderer_(renderer)
    {
        if (renderer->at_work.exchange(true))
            base::fail(CLQ_BUSY, "another call is at work with this renderer: calls come one at a time");
    }
    ~Rendering()
    {
        if (renderer_) renderer_->at_work = false;
    }
    Rendering(const Rendering &) = delete;
    Rendering &operator=(const Rendering &) = delete;
    void end() { renderer_ = nullptr; }  // the renderer is destroyed

private:
    const clq_renderer *renderer_;
};

}  // namespace claque::api
