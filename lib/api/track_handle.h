// The structs behind clq_locomotion and clq_track. Each has a reference count: one for the host, one for each track or
// crowd that uses it.
#pragma once

#include <claque/track.h>

#include "lib/api/handles.h"
#include "lib/track/track.h"

struct clq_locomotion : claque::track::Locomotion {
    explicit clq_locomotion(clq_template *of) : Locomotion(&of->context->memory), context(of->context), held(of)
    {
        claque::api::hold(of);
    }
    ~clq_locomotion() { claque::api::release(held); }
    clq_context *context;
    clq_template *held;
    mutable std::atomic<uint32_t> holders{1};
};

struct clq_track : claque::track::Track {
    explicit clq_track(const clq_locomotion *of) : Track(&of->context->memory), context(of->context), held(of)
    {
        ++of->holders;
    }
    ~clq_track();
    clq_context *context;
    const clq_locomotion *held;
    std::atomic<uint32_t> holders{1};
};

namespace claque::api
{

void release(const clq_locomotion *locomotion);
void release(clq_track *track);
inline void hold(clq_track *track) { ++track->holders; }

}  // namespace claque::api
