// S0 4.2 step 5, 5.3: behaviour of who passed phase 2 and is due; of nobody else, but for what keeps a memory.
#include "lib/behave/behave.h"

#include <cmath>

#include "lib/frame/steps.h"

namespace claque::frame
{

// Mechanisms of the host that keep a memory run in every update for everybody who uses them, in the order of rows, and are
// told nothing that depends on who is seen: what they remember is the same in both cull modes.
void Update::run_memories()
{
    float *nowhere = frame.dofs_.data() + frame.caches_.pending().size() * frame.max_dofs_;
    for (uint32_t row = 0; row < crowd.row_count(); ++row) {
        if (!crowd.alive(row) || !behave::has_memory(crowd, row)) continue;
        const uint32_t group = crowd.group_of(row);
        if (group != model::none && !crowd.group(group).enabled) continue;
        double nearest = 0;
        for (uint32_t v = 0; v < views.count; ++v) {
            const glm::dvec3 away = position_of(row) - views[v]->camera.eye;
            const double distance = std::sqrt(away.x * away.x + away.y * away.y + away.z * away.z);
            if (v == 0 || distance < nearest) nearest = distance;
        }
        behave::EvaluationContext context;
        context.time_s = time_s;
        context.distance = static_cast<float>(nearest);
        context.level = &crowd.template_of(row).levels[0];
        context.visible = false;
        const float distance_m = context.distance * frame.settings_.caches.metres_per_unit;
        context.levels = behave::mechanism_levels(crowd, row, distance_m, *context.level);
        const animcache::Request *request = find_request(row);
        float *out = request && request->dofs ? dofs_of(*request) : nowhere;
        context.wanted = out != nowhere;
        behave::run(crowd, row, context, {out, static_cast<uint32_t>(crowd.template_of(row).rig.dofs.size())},
                    frame.stats_.behaviour);
    }
}

// The request of a row in this update, or null.
const animcache::Request *Update::find_request(uint32_t row) const
{
    const Row &found = frame.rows_[row];
    const bool is =
        found.update == frame.update_ && found.generation == crowd.actor(row).generation && found.visibility.visible;
    return is ? &frame.caches_.request_of(row) : nullptr;
}

float *Update::dofs_of(const animcache::Request &request) const
{
    return frame.dofs_.data() + size_t(&request - frame.caches_.pending().data()) * frame.max_dofs_;
}

void Update::behave()
{
    frame.stats_.behaviour = behave::Counts();
    frame.behaving_.clear();
    std::pmr::vector<animcache::Request> &requests = frame.caches_.pending();
    for (uint32_t i = 0; i < requests.size(); ++i) {
        animcache::Request &request = requests[i];
        if (!crowd.behaviours().has_mechanisms(request.row) || !frame.caches_.is_due(request)) continue;
        if (!request.tmpl->rig.dofs.empty()) request.dofs = dofs_of(request);
        if (!behave::has_memory(crowd, request.row)) frame.behaving_.push_back(i);
    }
    const auto run = [&](uint32_t k, behave::Counts &counts) {
        const animcache::Request &request = requests[frame.behaving_[k]];
        const Candidate &candidate = frame.candidates_[frame.requested_[frame.behaving_[k]]];
        const Row &found = frame.rows_[request.row];
        behave::EvaluationContext context;
        context.time_s = found.visibility.shown_s;
        context.levels = candidate.levels;
        context.level = &request.tmpl->levels[request.level];
        context.distance = found.visibility.distance;
        behave::run(crowd, request.row, context,
                    {dofs_of(request), static_cast<uint32_t>(request.tmpl->rig.dofs.size())}, counts);
    };
    if (crowd.behaviours().any_memory()) run_memories();
    const uint32_t count = static_cast<uint32_t>(frame.behaving_.size());
    if (crowd.behaviours().any_host()) {
        for (uint32_t k = 0; k < count; ++k) run(k, frame.stats_.behaviour);
        return;
    }
    constexpr uint32_t slices = 64;
    behave::Counts counts[slices];
    jobs.for_each(slices, [&](uint32_t s) {
        const uint32_t first = static_cast<uint32_t>(uint64_t(count) * s / slices);
        const uint32_t last = static_cast<uint32_t>(uint64_t(count) * (s + 1) / slices);
        for (uint32_t k = first; k < last; ++k) run(k, counts[s]);
    });
    for (const behave::Counts &c : counts) frame.stats_.behaviour.add(c);
}

}  // namespace claque::frame
