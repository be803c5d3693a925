// One tick.
#include <algorithm>
#include <cmath>

#include "lib/stage/walk/walkers.h"

namespace claque::walk
{

namespace
{

constexpr float body_depth = 1.36f;  // from front to back, in radii of the body, which is wider: 0.3 m
constexpr float min_speed = 0.1f;    // so that no two wait for each other
constexpr float alone_m = 0.5f;      // so near its goal a walker leaves others no more room than their bodies need
constexpr float end_reach_m = 0.3f;  // of a way that leads to no goal

float between(const float *a, const Float3 &b) { return length_of(a[0] - b[0], a[2] - b[2]); }

}  // namespace

void Walkers::step()
{
    const std::lock_guard<std::mutex> lock(mesh_.lock);
    if (all_published_) pieces_.clear();
    else publish();
    see_doors();
    plan_ways();
    for (uint32_t i = 0; mesh_.has_byways && i < bodies_.size(); ++i)
        if (bodies_[i].used()) keep_to_byways(i);
    for (uint32_t i = 0; i < bodies_.size(); ++i)
        if (bodies_[i].used()) keep_distance(i), make_room(i);
    hold_still();
    crowd_->update(static_cast<float>(def_.tick_s), nullptr);
    put_still_back();
    ++ticks_;
    for (uint32_t i = 0; i < bodies_.size(); ++i)
        if (bodies_[i].used()) look_round(i), record(i);
    all_published_ = false;
    publish();
}

// People walk slower the closer the one before them is: the gap between the bodies divided by a time (the
// collision-free speed model of Tordeux, Chraibi and Seyfried 2016). DetourCrowd alone lets a crowd through a door at
// twice the rate that was measured. Walkers that come the other way or stand are walked round.
void Walkers::keep_distance(uint32_t i)
{
    const Body &body = bodies_[i];
    dtCrowdAgent &a = agent(i);
    a.params.maxSpeed = body.speed;
    a.params.separationWeight = rests(body) ? 0 : std::clamp(between(a.npos, body.goal) - alone_m, 0.0f, 1.0f);
    if (body.state != CLQ_WALKER_WALKS || !(def_.time_gap_s > 0)) return;
    const float length = length_of(a.dvel[0], a.dvel[2]);
    if (!(length > 0)) return;
    const float x = a.dvel[0] / length, z = a.dvel[2] / length, depth = body_depth * a.params.radius;
    for (int k = 0; k < a.nneis; ++k) {
        const dtCrowdAgent &other = agent(static_cast<uint32_t>(a.neis[k].idx));
        const float dx = other.npos[0] - a.npos[0], dz = other.npos[2] - a.npos[2];
        const bool ahead = dx * x + dz * z > 0 && std::fabs(dx * z - dz * x) < depth;
        const bool same_way = other.active && other.dvel[0] * x + other.dvel[2] * z > 0;
        if (!ahead || !same_way) continue;
        const float gap = length_of(dx, dz) - depth;
        a.params.maxSpeed = std::min(a.params.maxSpeed, std::max(min_speed, gap / def_.time_gap_s));
    }
}

// Arrivals, and the end of a stay in a closed door. The walls beside a walker are looked up again in each tick: they
// would else be those of an earlier place, and a walker would be more than what can be saved of it.
void Walkers::look_round(uint32_t i)
{
    Body &body = bodies_[i];
    dtCrowdAgent &a = agent(i);
    a.boundary.reset();
    if (a.params.queryFilterType == everything_filter) {
        if (!(flags_of(mesh_, a.corridor.getFirstPoly()) & closed_flag)) {
            a.params.queryFilterType = open_filter;
            if (body.state == CLQ_WALKER_WALKS)
                body.state = CLQ_WALKER_WAITS, crowd_->resetMoveTarget(static_cast<int>(i));
        }
    }
    if (body.state != CLQ_WALKER_WALKS) return;
    aim(i);
    if (body.complete && (between(a.npos, body.goal) <= body.near_m || others_are_there(i)))
        rest(i, CLQ_WALKER_ARRIVED);
    else if (!body.complete && between(a.npos, body.end) <= std::max(body.near_m, end_reach_m))
        rest(i, body.cut ? CLQ_WALKER_WAITS : CLQ_WALKER_BLOCKED);
}

// The direction of its way: to the next corner that is farther than its radius.
void Walkers::aim(uint32_t i)
{
    const dtCrowdAgent &a = agent(i);
    if (a.targetState != DT_CROWDAGENT_TARGET_VALID) return;
    float x = 0, z = 0, length = 0;
    for (int k = 0; k < a.ncorners && !(length > a.params.radius); ++k) {
        x = a.cornerVerts[3 * k] - a.npos[0], z = a.cornerVerts[3 * k + 2] - a.npos[2];
        length = length_of(x, z);
    }
    if (length > 0) bodies_[i].aim[0] = x / length, bodies_[i].aim[1] = z / length;
}

void Walkers::rest(uint32_t i, clq_walker_state state)
{
    const dtCrowdAgent &a = agent(i);
    bodies_[i].state = state;
    bodies_[i].aim[0] = bodies_[i].aim[1] = 0;
    bodies_[i].end = {a.npos[0], a.npos[1], a.npos[2]};
    crowd_->resetMoveTarget(static_cast<int>(i));
}

void Walkers::record(uint32_t i)
{
    Body &body = bodies_[i];
    if (!body.locomotion) return;
    clq_track_point point{};
    point.time_s = time_s();
    show(i, agent(i).npos, time_s(), point.position);
    point.heading_rad = rests(body) ? body.heading_rad : NAN;
    body.points.push_back(point);
}

}  // namespace claque::walk
