// claque's statuses as C++ exceptions, and its owners as smart pointers, for samples and tests.
#pragma once

#include <claque/assets.h>
#include <claque/claque.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace scenes
{

// One sentence for the user of the program.
struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

inline void check(clq_status status, const std::string &doing = {})
{
    if (status != CLQ_OK) throw Failure((doing.empty() ? "" : doing + ": ") + clq_last_error());
}

// Works, and puts the place in a file that asked for it before the sentence of a failure; empty: nothing.
template <class Work>
auto asked_at(const std::string &place, const Work &work)
{
    try {
        return work();
    } catch (const Failure &failure) {
        throw Failure((place.empty() ? "" : place + ": ") + failure.what());
    }
}

struct Destroy {
    void operator()(clq_context *p) const { clq_context_destroy(p); }
    void operator()(clq_template *p) const { clq_template_destroy(p); }
    void operator()(clq_asset *p) const { clq_asset_destroy(p); }
    void operator()(clq_crowd *p) const { clq_crowd_destroy(p); }
    void operator()(clq_view *p) const { clq_view_destroy(p); }
    void operator()(clq_renderer *p) const { clq_renderer_destroy(p); }
};

template <class Thing>
using Own = std::unique_ptr<Thing, Destroy>;

}  // namespace scenes
