// Ways for walkers that wait for one, and what a door that moved means for the others.
#include <algorithm>

#include "lib/stage/walk/walkers.h"

namespace claque::walk
{

namespace
{

constexpr int checked_polygons = 10;  // of its way, which are to be open to the walker

bool is_closed(const Mesh &mesh, dtPolyRef polygon) { return flags_of(mesh, polygon) & closed_flag; }

}  // namespace

// Walkers whose way a door bars look for another; walkers whose way ended look again. Walkers in a closed door walk
// out.
void Walkers::see_doors()
{
    if (mesh_version_ == mesh_.version) return;
    mesh_version_ = mesh_.version;
    for (uint32_t i = 0; i < bodies_.size(); ++i) {
        Body &body = bodies_[i];
        if (!body.used()) continue;
        dtCrowdAgent &a = agent(i);
        a.params.queryFilterType = is_closed(mesh_, a.corridor.getFirstPoly()) ? everything_filter : open_filter;
        const dtPolyRef *path = a.corridor.getPath();
        const bool barred = std::any_of(path, path + a.corridor.getPathCount(),
                                        [&](dtPolyRef polygon) { return is_closed(mesh_, polygon); });
        const bool again = body.state == CLQ_WALKER_WALKS && (barred || !body.complete);
        if (!again && body.state != CLQ_WALKER_BLOCKED) continue;
        crowd_->resetMoveTarget(static_cast<int>(i));
        body.state = CLQ_WALKER_WAITS;
    }
}

// A walker is kept out of byways that are not its own, as by walls. In one, and where its way leads through others, all
// are open to it.
void Walkers::keep_to_byways(uint32_t i)
{
    dtCrowdAgent &a = agent(i);
    if (a.params.queryFilterType == everything_filter) return;
    unsigned on_way = flags_of(mesh_, a.corridor.getFirstPoly()), own = 0;
    if (a.targetState == DT_CROWDAGENT_TARGET_VALID) {
        own = flags_of(mesh_, a.targetRef) & byway_flags;
        const dtPolyRef *path = a.corridor.getPath();
        for (int k = 1; k < std::min(a.corridor.getPathCount(), checked_polygons); ++k)
            on_way |= flags_of(mesh_, path[k]);
    }
    a.params.queryFilterType = open_filter;
    if (on_way & byway_flags & ~own) a.params.queryFilterType = any_byway_filter;
    else if (own != 0)
        for (uint32_t group = 0; group < CLQ_BYWAY_GROUPS; ++group)
            if (own & byway_flag(group)) a.params.queryFilterType = static_cast<unsigned char>(byway_filter + group);
}

void Walkers::plan_ways()
{
    uint32_t found = 0;
    const uint32_t size = static_cast<uint32_t>(bodies_.size());
    for (uint32_t k = 0; k < size && found < def_.plans; ++k) {
        const uint32_t i = (next_plan_ + k) % size;
        if (!bodies_[i].used() || bodies_[i].state != CLQ_WALKER_WAITS) continue;
        plan(i);
        if (++found == def_.plans) next_plan_ = (i + 1) % size;
    }
    plans_ += found;
}

void Walkers::plan(uint32_t i)
{
    Body &body = bodies_[i];
    dtCrowdAgent &a = agent(i);
    const dtPolyRef here = a.corridor.getFirstPoly();
    const bool out_of_door = a.params.queryFilterType == everything_filter;
    const dtQueryFilter filter = out_of_door ? mesh_.everything : filter_of_way(mesh_, here, body.goal_ref);
    const Float3 from = {a.npos[0], a.npos[1], a.npos[2]};
    find_way(mesh_, here, from, body.goal_ref, body.goal, filter, way_);
    body.complete = way_.complete;
    body.cut = !way_.complete && way_.polygons.size() == max_way_polys;
    body.end = way_.end;
    if (way_.polygons.empty()) {
        body.state = CLQ_WALKER_BLOCKED;
        crowd_->resetMoveTarget(static_cast<int>(i));
        return;
    }
    body.state = CLQ_WALKER_WALKS;
    a.corridor.setCorridor(way_.end.data(), way_.polygons.data(), static_cast<int>(way_.polygons.size()));
    a.partial = !way_.complete;
    a.targetRef = way_.polygons.back();
    std::copy(way_.end.begin(), way_.end.end(), a.targetPos);
    a.targetPathqRef = DT_PATHQ_INVALID;
    a.targetReplan = false, a.targetReplanTime = 0;
    a.targetState = DT_CROWDAGENT_TARGET_VALID;
}

}  // namespace claque::walk
