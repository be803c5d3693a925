#include "lib/stage/walk/walkers.h"

#include <algorithm>
#include <cmath>
#include <new>

namespace claque::walk
{

namespace
{

constexpr double kept_s = 2;  // of points before a piece, as claque/track.h wants them

clq_walkers_def checked(const clq_walkers_def &def)
{
    require_range("max_count", def.max_count, 1, 16000);
    require_range("max_radius_m", double(def.max_radius_m), 0.05, 2);
    require_range("start_s", def.start_s, -1e9, 1e9);
    require_range("tick_s", def.tick_s, 0.01, 0.2);
    require_range("piece_ticks", def.piece_ticks, 2, 200);
    require_range("piece_ticks times tick_s", def.piece_ticks * def.tick_s, 0.0999, 10);
    require_range("plans", def.plans, 1, 16000);
    require_range("smooth_s", double(def.smooth_s), 0, 2);
    require_range("time_gap_s", double(def.time_gap_s), 0, 5);
    require_range("climbing", double(def.climbing), 0.01, 1);
    require_range("descending", double(def.descending), 0.01, 1);
    return def;
}

void set_filters(dtCrowd &crowd, const Mesh &mesh)
{
    *crowd.getEditableFilter(open_filter) = mesh.open;
    crowd.getEditableFilter(open_filter)->setIncludeFlags(walk_flag);
    *crowd.getEditableFilter(everything_filter) = mesh.everything;
    *crowd.getEditableFilter(any_byway_filter) = mesh.open;
    for (uint32_t group = 0; group < CLQ_BYWAY_GROUPS; ++group) {
        dtQueryFilter &filter = *crowd.getEditableFilter(static_cast<int>(byway_filter + group));
        filter = mesh.open;
        filter.setIncludeFlags(static_cast<unsigned short>(walk_flag | byway_flag(group)));
    }
}

dtCrowdAgentParams agent_of(const clq_walker_def &def)
{
    dtCrowdAgentParams params{};
    params.radius = def.radius_m;
    params.height = 1.9f;
    params.maxAcceleration = def.acceleration_m_s2;
    params.pathOptimizationRange = 30 * def.radius_m;
    params.queryFilterType = open_filter;
    return params;
}

void check_walker(const clq_walker_def &def, const clq_walkers_def &walkers)
{
    for (const double x : def.position)
        if (!std::isfinite(x)) fail(CLQ_ARGUMENT, "the position of a walker is not finite");
    require_range("heading_rad", double(def.heading_rad), -1e6, 1e6);
    require_range("radius_m", double(def.radius_m), 0.05, double(walkers.max_radius_m));
    require_range("speed_m_s", double(def.speed_m_s), 0.01, 8);
    require_range("acceleration_m_s2", double(def.acceleration_m_s2), 0.1, 50);
    require_range("scale", double(def.scale), 1e-3, 1e3);
}

}  // namespace

Walkers::Walkers(clq_navigation &mesh, const clq_walkers_def &def)
    : mesh_(mesh), def_(checked(def)), crowd_(dtAllocCrowd())
{
    if (!crowd_ || !crowd_->init(static_cast<int>(def.max_count), def.max_radius_m, mesh.nav.get()))
        throw std::bad_alloc();
    set_filters(*crowd_, mesh);
    bodies_.resize(def.max_count);
    pieces_.reserve(def.max_count);
    way_.polygons.reserve(max_way_polys);
    scratch_.wishes.resize(def.max_count), scratch_.around.resize(def.max_count), scratch_.pushes.resize(def.max_count);
    scratch_.ranks.resize(def.max_count), scratch_.by_rank.reserve(def.max_count);
    mesh_version_ = mesh.version;
    ++mesh_.holders;
}

Walkers::~Walkers() { clq_navigation_destroy(&mesh_); }

uint32_t Walkers::index_of(clq_walker id) const
{
    if (id.index1 == 0 || id.index1 > bodies_.size()) fail(CLQ_ARGUMENT, "%u is no walker", id.index1);
    const Body &body = bodies_[id.index1 - 1];
    if (!body.used() || body.generation != id.generation) fail(CLQ_STALE_ID, "walker %u was removed", id.index1);
    return id.index1 - 1;
}

clq_walker Walkers::add(const clq_walker_def &def)
{
    check_walker(def, def_);
    const std::lock_guard<std::mutex> lock(mesh_.lock);
    Float3 place{};
    const dtPolyRef ref = nearest(mesh_, mesh_.local(def.position), find_reach_m, mesh_.open, place);
    if (!ref)
        fail(CLQ_ARGUMENT, "there is no ground within %g m of %g, %g, %g for a walker", double(find_reach_m),
             def.position[0], def.position[1], def.position[2]);
    if (count_ == def_.max_count) fail(CLQ_LIMIT, "%u walkers: no more were asked for", count_);
    std::vector<clq_track_point> points;
    points.reserve(static_cast<size_t>(kept_s / def_.tick_s) + 2 * size_t(def_.piece_ticks) + 16);
    const dtCrowdAgentParams params = agent_of(def);
    const int i = crowd_->addAgent(place.data(), &params);
    if (i < 0) fail(CLQ_LIMIT, "the crowd takes no more than %u walkers", count_);
    dtCrowdAgent &made = agent(static_cast<uint32_t>(i));
    made.corridor.reset(ref, place.data());  // the crowd looks for it with other reaches
    std::copy(place.begin(), place.end(), made.npos);
    made.state = DT_CROWDAGENT_STATE_WALKING;
    Body &body = bodies_[static_cast<size_t>(i)];
    const uint32_t generation = body.generation + 1;
    body = Body();
    body.generation = generation;
    body.locomotion = def.locomotion, body.scale = def.scale, body.seed = def.seed;
    body.heading_rad = def.heading_rad, body.own_speed = body.speed = def.speed_m_s;
    body.points = std::move(points);
    body.goal = body.end = place;
    body.piece_end_s = time_s();
    body.border = first_border(static_cast<uint32_t>(i));
    ++count_;
    record(static_cast<uint32_t>(i));
    return id_of(static_cast<uint32_t>(i));
}

// Walkers have their borders at different ticks, but none so soon that its first piece would be too short.
uint32_t Walkers::first_border(uint32_t i) const
{
    const uint32_t now = static_cast<uint32_t>(ticks_ % def_.piece_ticks);
    const auto least = static_cast<uint32_t>(std::ceil(min_piece_s / def_.tick_s));
    const uint32_t away = std::max(i % def_.piece_ticks + 1, least);
    return (now + away) % def_.piece_ticks;
}

void Walkers::remove(clq_walker id)
{
    const uint32_t i = index_of(id);
    crowd_->removeAgent(static_cast<int>(i));
    const uint32_t generation = bodies_[i].generation + 1;
    bodies_[i] = Body();
    bodies_[i].generation = generation;
    --count_;
}

void Walkers::go(clq_walker id, const double goal[3], float near_m, float speed_m_s)
{
    const uint32_t i = index_of(id);
    for (int k = 0; k < 3; ++k)
        if (!std::isfinite(goal[k])) fail(CLQ_ARGUMENT, "the goal of walker %u is not finite", id.index1);
    require_range("near_m", double(near_m), 0.05, 100);
    require_range("speed_m_s", double(speed_m_s), 0, 8);
    const std::lock_guard<std::mutex> lock(mesh_.lock);
    Float3 place{};
    const dtPolyRef ref = nearest(mesh_, mesh_.local(goal), find_reach_m, mesh_.everything, place);
    if (!ref)
        fail(CLQ_ARGUMENT, "there is no ground within %g m of the goal %g, %g, %g", double(find_reach_m), goal[0],
             goal[1], goal[2]);
    Body &body = bodies_[i];
    body.goal = place, body.goal_ref = ref, body.near_m = near_m;
    body.state = CLQ_WALKER_WAITS;
    body.heading_rad = NAN;
    return_to_ground(body);
    body.speed = speed_m_s > 0 ? speed_m_s : body.own_speed;
}

void Walkers::stop(clq_walker id)
{
    const uint32_t i = index_of(id);
    Body &body = bodies_[i];
    return_to_ground(body);
    const float *at = agent(i).npos;
    if (!rests(body)) body.goal = {at[0], at[1], at[2]};
    if (!rests(body)) rest(i, CLQ_WALKER_STANDS);
    body.state = CLQ_WALKER_STANDS;
    body.heading_rad = NAN;
}

void Walkers::rest_at(clq_walker id, float heading_rad) { bodies_[index_of(id)].heading_rad = heading_rad; }

void Walkers::stand_since(clq_walker id, double time_s)
{
    const uint32_t i = index_of(id);
    Body &body = bodies_[i];
    if (!body.locomotion || !(time_s < this->time_s())) return;
    body.points.insert(body.points.begin(), body.points.back());
    body.points.front().time_s = body.piece_end_s = time_s;
    if (this->time_s() - time_s > min_piece_s) publish(i);
}

void Walkers::get(clq_walker id, clq_walker_info &out) const
{
    const uint32_t i = index_of(id);
    const dtCrowdAgent &a = agent(i);
    out.state = bodies_[i].state;
    mesh_.world(a.npos, out.position);
    std::copy(a.vel, a.vel + 3, out.velocity_m_s);
    out.last_piece_s = bodies_[i].piece_end_s;
}

void Walkers::get(clq_walkers_info &out) const
{
    out.count = count_, out.time_s = time_s(), out.ticks = ticks_, out.plans = plans_, out.pieces = published_;
    uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&hash](const void *bytes, size_t count) {
        for (size_t k = 0; k < count; ++k)
            hash = (hash ^ static_cast<const unsigned char *>(bytes)[k]) * 0x100000001b3u;
    };
    add(&ticks_, sizeof ticks_);
    for (uint32_t i = 0; i < bodies_.size(); ++i) {
        if (!bodies_[i].used()) continue;
        out.waiting += bodies_[i].state == CLQ_WALKER_WAITS;
        const dtCrowdAgent &a = agent(i);
        add(&i, sizeof i), add(&bodies_[i].state, sizeof bodies_[i].state);
        add(a.npos, sizeof a.npos), add(a.vel, sizeof a.vel);
    }
    out.hash = hash;
}

}  // namespace claque::walk
