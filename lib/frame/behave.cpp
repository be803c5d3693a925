// S0 4.2 step 5, 5.3: runs the control mechanisms of actors that passed phase 2 and are due. Host mechanisms with a
// memory run for all their actors.
#include "lib/behave/behave.h"

#include <cmath>

#include "lib/frame/steps.h"

namespace claque::frame
{

// Host mechanisms with a memory run in every update for all actors that use them, in the order of rows. Their arguments
// do not depend on visibility, so their memory is the same in both cull modes.
void Behave::run_memories() const
{
    const crowd::Crowd &crowd = given.crowd;
    float *nowhere = dofs_of(candidates.count);
    for (uint32_t row = 0; row < crowd.row_count(); ++row) {
        if (!crowd.alive(row) || !behave::has_memory(crowd, row)) continue;
        const uint32_t group = crowd.group_of(row);
        if (group != model::none && !crowd.group(group).enabled) continue;
        double nearest = 0;
        for (uint32_t v = 0; v < given.eyes.count; ++v) {
            const glm::dvec3 away = crowd::reference_position_of(crowd, row, given.time_s) - given.eyes[v].eye;
            const double distance = std::sqrt(away.x * away.x + away.y * away.y + away.z * away.z);
            if (v == 0 || distance < nearest) nearest = distance;
        }
        behave::EvaluationContext context;
        context.host_calls = &given.host_calls;
        context.time_s = given.time_s;
        context.distance_m = static_cast<float>(nearest) * given.settings.caches.metres_per_unit;
        context.level = &crowd.template_of(row).levels[0];
        context.visible = false;
        context.levels = behave::mechanism_levels(crowd, row, context.distance_m, *context.level);
        const uint32_t i = asking(row);
        context.wanted = i != model::none && caches.pending()[i].dofs;
        float *out = context.wanted ? dofs_of(i) : nowhere;
        behave::run(crowd, row, context, {out, static_cast<uint32_t>(crowd.template_of(row).rig.dofs.size())},
                    stats.behaviour);
    }
}

// The visible candidate of this update that a row is, or none.
uint32_t Behave::asking(uint32_t row) const
{
    const uint32_t slot = seen.slot_of(row);
    if (slot == model::none) return model::none;
    const Row &found = rows[slot];
    const bool asks = found.update == given.update && found.generation == given.crowd.actor(row).generation &&
                      found.visibility.visible;
    return asks ? found.candidate : model::none;
}

void Behave::run_one(uint32_t i, behave::Counts &counts) const
{
    const animcache::Request &request = caches.pending()[i];
    const Row &found = rows[request.slot];
    behave::EvaluationContext context;
    context.host_calls = &given.host_calls;
    context.time_s = found.visibility.shown_s;
    context.levels = candidates[i].levels;
    context.level = &request.tmpl->levels[request.level];
    context.distance_m = found.visibility.distance * given.settings.caches.metres_per_unit;
    behave::run(given.crowd, request.row, context, {dofs_of(i), static_cast<uint32_t>(request.tmpl->rig.dofs.size())},
                counts);
}

base::Status Behave::check() const
{
    if (behaving.count < candidates.count || !has_slots(candidates, rows))
        return base::Status::bad(CLQ_ARGUMENT, "no room for every candidate");
    // A crowd whose mechanisms went with a restore may hold the array of a smaller one: nothing writes it then.
    if (given.crowd.behaviours().mechanism_count() > 0 && dofs.count < (size_t(candidates.count) + 1) * dofs_each)
        return base::Status::bad(CLQ_ARGUMENT, "no room for the degrees of freedom of every candidate");
    return base::Status::good();
}

void Behave::run() const
{
    stats.behaviour = behave::Counts();
    std::pmr::vector<animcache::Request> &requests = caches.pending();
    uint32_t count = 0;
    for (uint32_t i = 0; i < requests.size(); ++i) {
        animcache::Request &request = requests[i];
        if (!request.tmpl || !given.crowd.behaviours().has_mechanisms(request.row) || !caches.is_due(request)) continue;
        if (!request.tmpl->rig.dofs.empty()) request.dofs = dofs_of(i);
        if (!behave::has_memory(given.crowd, request.row)) behaving[count++] = i;
    }
    if (given.crowd.behaviours().any_memory()) run_memories();
    if (given.crowd.behaviours().any_host()) {
        for (uint32_t k = 0; k < count; ++k) run_one(behaving[k], stats.behaviour);
        return;
    }
    constexpr uint32_t slices = 64;
    behave::Counts counts[slices];
    given.jobs.for_each(slices, [&](uint32_t s) {
        const uint32_t first = static_cast<uint32_t>(uint64_t(count) * s / slices);
        const uint32_t last = static_cast<uint32_t>(uint64_t(count) * (s + 1) / slices);
        for (uint32_t k = first; k < last; ++k) run_one(behaving[k], counts[s]);
    });
    for (const behave::Counts &c : counts) stats.behaviour.add(c);
}

}  // namespace claque::frame
