// The struct behind clq_renderer.
#pragma once

#include <claque/renderer.h>

#include "lib/api/handles.h"
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
};
