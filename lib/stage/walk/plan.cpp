// Ways for walkers that wait for one, and what a door that moved means for the others.
#include <algorithm>

#include "lib/stage/walk/walkers.h"

namespace claque::walk
{

namespace
{

bool is_closed(const Mesh &mesh, dtPolyRef polygon)
{
    unsigned short flags = 0;
    return dtStatusSucceed(mesh.nav->getPolyFlags(polygon, &flags)) && (flags & closed_flag);
}

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
        a.boundary.reset();
        const dtPolyRef *path = a.corridor.getPath();
        const bool barred = std::any_of(path, path + a.corridor.getPathCount(),
                                        [&](dtPolyRef polygon) { return is_closed(mesh_, polygon); });
        const bool again = body.state == CLQ_WALKER_WALKS && (barred || !body.complete);
        if (!again && body.state != CLQ_WALKER_BLOCKED) continue;
        crowd_->resetMoveTarget(static_cast<int>(i));
        body.state = CLQ_WALKER_WAITS;
    }
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
    const dtQueryFilter &filter = a.params.queryFilterType == open_filter ? mesh_.open : mesh_.everything;
    const Float3 from = {a.npos[0], a.npos[1], a.npos[2]};
    find_way(mesh_, a.corridor.getFirstPoly(), from, body.goal_ref, body.goal, filter, way_);
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
    a.boundary.reset();
    a.partial = !way_.complete;
    a.targetRef = way_.polygons.back();
    std::copy(way_.end.begin(), way_.end.end(), a.targetPos);
    a.targetPathqRef = DT_PATHQ_INVALID;
    a.targetReplan = false, a.targetReplanTime = 0;
    a.targetState = DT_CROWDAGENT_TARGET_VALID;
}

}  // namespace claque::walk
