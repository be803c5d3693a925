#include "lib/api/host_resolver.h"

#include <algorithm>

#include "lib/api/behave_def.h"
#include "lib/api/boundary.h"
#include "lib/api/saved_def.h"
#include "lib/api/scene_handle.h"
#include "lib/api/track_handle.h"
#include "lib/crowd/restore.h"
#include "lib/crowd/save_fields.h"

namespace claque::api
{

namespace
{

template <class Body>
void as_format(const char *what, uint32_t index, const Body &body)
{
    try {
        body();
    } catch (const base::Error &error) {
        base::fail(CLQ_FORMAT, "%s %u of a saved crowd: %s", what, index + 1, error.what());
    }
}

void walk(crowd::Writer &out, const crowd::RootPath &path) { walk_path(out, path); }

void walk(crowd::Writer &out, const crowd::Mechanism &mechanism)
{
    walk_levels(out, mechanism);
    std::visit([&](const auto &kind) { walk_kind(out, kind); }, mechanism.kind);
}

template <class Description>
uint64_t hash_of(const Description &description)
{
    base::HashingSink measure;
    crowd::Writer out(measure);
    walk(out, description);
    out.flush();
    return measure.hash;
}

// A host's description is completed when it is taken: a path's lap is closed. What a crowd saves is complete, so that a
// restored crowd saves the same bytes.
template <class Description>
void require_same(const Description &made, const Description &saved)
{
    if (hash_of(made) != hash_of(saved)) base::fail(CLQ_FORMAT, "no crowd saves it like this");
}

}  // namespace

clq_template *take_template(std::pmr::vector<clq_template *> &left, std::string_view name, uint64_t structure,
                            const char *whose)
{
    bool named = false;
    for (clq_template *&tmpl : left) {
        if (!tmpl || tmpl->name != name) continue;
        named = true;
        if (crowd::structure_hash(*tmpl) == structure) return std::exchange(tmpl, nullptr);
    }
    if (named)
        base::fail(CLQ_ARGUMENT,
                   "template '%s' is not the one that %s used: its nodes, degrees of freedom, clips, zones or levels "
                   "differ",
                   std::string(name).c_str(), whose);
    base::fail(CLQ_ARGUMENT, "template '%s' of %s is not among those given", std::string(name).c_str(), whose);
}

void check_templates(const clq_context *context, clq_template *const *templates, uint32_t count)
{
    require_array(templates, count, "templates");
    for (uint32_t i = 0; i < count; ++i) {
        if (!templates[i]) base::fail(CLQ_ARGUMENT, "template %u is NULL", i);
        if (templates[i]->context != context) base::fail(CLQ_ARGUMENT, "template %u was made from another context", i);
        for (uint32_t k = 0; k < i; ++k)
            if (templates[k] == templates[i]) base::fail(CLQ_ARGUMENT, "templates %u and %u are the same", k, i);
    }
}

HostResolver::HostResolver(const clq_crowd &crowd, clq_template *const *templates, uint32_t count,
                           const LentMechanisms *lent)
    : crowd_(crowd), lent_(lent), left_(&crowd.context->memory), used_(&crowd.context->memory)
{
    left_.assign(templates, templates + count);
    used_.reserve(count);
}

const model::Template &HostResolver::find_template(std::string_view name, uint64_t structure)
{
    used_.push_back(take_template(left_, name, structure, "the saved crowd"));
    return *used_.back();
}

void HostResolver::add(crowd::Behaviours &out, uint32_t index, crowd::Mechanism &&mechanism)
{
    if (crowd::HostMechanism *host = std::get_if<crowd::HostMechanism>(&mechanism.kind)) lend(index, *host);
    as_format("mechanism", index, [&] {
        std::pmr::memory_resource *memory = &crowd_.context->memory;
        const MechanismDef saved(mechanism, memory);
        model::Array<uint32_t> written(memory);
        crowd::Mechanism made = mechanism_of(saved.def, *mechanism.tmpl, memory, written);
        require_same(made, mechanism);
        out.add(std::move(made), base::Span<const uint32_t>(written));
    });
}

void HostResolver::add(crowd::Behaviours &out, uint32_t index, crowd::RootPath &&path)
{
    as_format("path", index, [&] {
        std::pmr::memory_resource *memory = &crowd_.context->memory;
        crowd::RootPath made = path_of(RootPathDef(path, memory).def, memory);
        require_same(made, path);
        out.add(std::move(made));
    });
}

void HostResolver::lend(uint32_t index, crowd::HostMechanism &host) const
{
    const crowd::Behaviours &here = crowd_.crowd.behaviours();
    const crowd::HostMechanism *own =
        index < here.mechanism_count() ? std::get_if<crowd::HostMechanism>(&here.mechanism(index).kind) : nullptr;
    if (lent_)
        if (const auto found = lent_->find(index + 1); found != lent_->end()) {
            host.run = found->second.run, host.user = found->second.user;
            return;
        }
    // What is missing is no fault of the bytes.
    if (!own)
        throw crowd::Missing(
            CLQ_ARGUMENT,
            base::text_of("mechanism %u of the saved crowd is the host's own: this crowd has none of that number to "
                          "take its callback from%s",
                          index + 1, lent_ ? "; clq_record_lend_mechanism lends one" : ""));
    if (own->memory != host.memory)
        throw crowd::Missing(CLQ_ARGUMENT, base::text_of("mechanism %u, the host's own, keeps a memory %s", index + 1,
                                                         own->memory ? "here but not in the saved crowd"
                                                                     : "in the saved crowd but not here"));
    host = *own;
}

void restore_state(clq_crowd *crowd, const uint8_t *bytes, size_t size, HostResolver &resolver)
{
    crowd::Crowd restored(&crowd->context->memory);
    for (const clq_track *track : crowd->tracks) restored.tables.follows.add(*track);
    crowd::restore(bytes, size, resolver, restored);

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
        hold(tmpl);
        crowd->held.push_back(tmpl);
    }
    crowd->frame.forget();
}

}  // namespace claque::api
