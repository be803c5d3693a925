// Saves and restores crowds; supplies what a saved crowd does not contain: templates and callbacks.
#include "lib/crowd/save.h"

#include <claque/save.h>

#include <algorithm>

#include "lib/api/behave_def.h"
#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"
#include "lib/api/saved_def.h"
#include "lib/api/scene_handle.h"
#include "lib/api/track_handle.h"

using namespace claque;

namespace
{

class HostSink : public base::Sink
{
public:
    HostSink(clq_write_function write, void *user) : write_(write), user_(user) {}
    void take(const uint8_t *bytes, size_t count) override
    {
        if (!api::host_takes(write_, user_, bytes, count))
            base::fail(CLQ_IO, "the writer refused %zu bytes of a saved crowd, after %zu that it took", count, taken_);
        taken_ += count;
    }

private:
    clq_write_function write_;
    void *user_;
    size_t taken_ = 0;
};

// Supplies the host's templates and callbacks to the crowd that is restored.
class HostResolver : public crowd::Resolver
{
public:
    HostResolver(const clq_crowd &crowd, clq_template *const *templates, uint32_t count)
        : crowd_(crowd), left_(&crowd.context->memory), used_(&crowd.context->memory)
    {
        left_.assign(templates, templates + count);
        used_.reserve(count);
    }

    const model::Template &find_template(std::string_view name, uint64_t structure) override
    {
        bool named = false;
        for (clq_template *&tmpl : left_) {
            if (!tmpl || tmpl->name != name) continue;
            named = true;
            if (crowd::structure_hash(*tmpl) != structure) continue;
            used_.push_back(tmpl);
            return *std::exchange(tmpl, nullptr);
        }
        if (named)
            base::fail(CLQ_ARGUMENT,
                       "template '%s' is not the one that the saved crowd used: its nodes, degrees of freedom, clips, "
                       "zones or levels differ",
                       std::string(name).c_str());
        base::fail(CLQ_ARGUMENT, "template '%s' of the saved crowd is not among those given",
                   std::string(name).c_str());
    }

    void add(crowd::Behaviours &out, uint32_t index, crowd::Mechanism &&mechanism) override
    {
        if (crowd::HostMechanism *host = std::get_if<crowd::HostMechanism>(&mechanism.kind)) lend(index, *host);
        as_format("mechanism", index, [&] {
            std::pmr::memory_resource *memory = &crowd_.context->memory;
            const api::MechanismDef saved(mechanism, memory);
            model::Array<uint32_t> written(memory);
            crowd::Mechanism made = api::mechanism_of(saved.def, *mechanism.tmpl, memory, written);
            out.add(std::move(made), base::Span<const uint32_t>(written));
        });
    }

    void add(crowd::Behaviours &out, uint32_t index, crowd::RootPath &&path) override
    {
        as_format("path", index, [&] {
            std::pmr::memory_resource *memory = &crowd_.context->memory;
            out.add(api::path_of(api::RootPathDef(path, memory).def, memory));
        });
    }

    const std::pmr::vector<clq_template *> &used() const { return used_; }

private:
    void lend(uint32_t index, crowd::HostMechanism &host) const
    {
        const crowd::Behaviours &here = crowd_.crowd.behaviours();
        const crowd::HostMechanism *own =
            index < here.mechanism_count() ? std::get_if<crowd::HostMechanism>(&here.mechanism(index).kind) : nullptr;
        if (!own)
            base::fail(CLQ_ARGUMENT,
                       "mechanism %u of the saved crowd is the host's own: this crowd has none of that number to take "
                       "its callback from",
                       index + 1);
        if (own->memory != host.memory)
            base::fail(CLQ_ARGUMENT, "mechanism %u, the host's own, keeps a memory %s", index + 1,
                       own->memory ? "here but not in the saved crowd" : "in the saved crowd but not here");
        host = *own;
    }

    template <class Body>
    static void as_format(const char *what, uint32_t index, const Body &body)
    {
        try {
            body();
        } catch (const base::Error &error) {
            base::fail(CLQ_FORMAT, "%s %u of a saved crowd: %s", what, index + 1, error.what());
        }
    }

    const clq_crowd &crowd_;
    std::pmr::vector<clq_template *> left_, used_;
};

void check_templates(const clq_crowd &crowd, clq_template *const *templates, uint32_t count)
{
    api::require_array(templates, count, "templates");
    for (uint32_t i = 0; i < count; ++i) {
        if (!templates[i]) base::fail(CLQ_ARGUMENT, "template %u is NULL", i);
        if (templates[i]->context != crowd.context)
            base::fail(CLQ_ARGUMENT, "template %u was made from another context", i);
        for (uint32_t k = 0; k < i; ++k)
            if (templates[k] == templates[i]) base::fail(CLQ_ARGUMENT, "templates %u and %u are the same", k, i);
    }
}

}  // namespace

extern "C" {

clq_status clq_crowd_save(const clq_crowd *crowd, clq_write_function write, void *user)
{
    return api::boundary("clq_crowd_save", [&] {
        api::require(crowd && write, "crowd or write is NULL");
        const api::Busy busy(crowd);
        HostSink sink(write, user);
        crowd::save(crowd->crowd, sink);
    });
}

clq_status clq_crowd_restore(clq_crowd *crowd, const void *bytes, size_t size_bytes, clq_template *const *templates,
                             uint32_t template_count)
{
    return api::boundary("clq_crowd_restore", [&] {
        api::require(crowd && bytes, "crowd or bytes is NULL");
        const api::Busy busy(crowd);
        check_templates(*crowd, templates, template_count);
        HostResolver resolver(*crowd, templates, template_count);
        crowd::Crowd restored(&crowd->context->memory);
        for (const clq_track *track : crowd->tracks) restored.tables.follows.add(*track);
        crowd::restore(static_cast<const uint8_t *>(bytes), size_bytes, resolver, restored);

        // Templates used before stay held: caches and draw lists may still point at them.
        const std::pmr::vector<clq_template *> &held = crowd->held;
        std::pmr::vector<clq_template *> fresh(&crowd->context->memory);
        fresh.reserve(resolver.used().size());
        for (clq_template *tmpl : resolver.used())
            if (std::find(held.begin(), held.end(), tmpl) == held.end()) fresh.push_back(tmpl);
        crowd->held.reserve(held.size() + fresh.size());
        for (clq_scene *scene : crowd->scenes) scene->scene.settle(crowd->crowd);
        crowd::swap_state(crowd->crowd, restored);
        for (clq_template *tmpl : fresh) {
            api::hold(tmpl);
            crowd->held.push_back(tmpl);
        }
        crowd->frame.forget();
    });
}

}  // extern "C"
