// One tick.
#include <algorithm>
#include <cmath>

#include "lib/stage/walk/walkers.h"

namespace claque::walk
{

namespace
{

constexpr float wide_m = 0.1f;  // round a corner
// Crowds turn on the whole width of a way: a walker that creeps before a corner goes round it wider and wider, and
// keeps some distance from the opposite wall.
constexpr float held_up = 0.5f, widening_m_s = 0.7f, opposite_m = 1.5f;
constexpr float sharp = 0.2f;        // the length of the difference of the directions before and after a corner
constexpr float passed_m = 0.06f;    // a corner so near is passed
constexpr int max_corners = 48;      // up to which its way is measured
constexpr float onward_m = 2.5f;     // along its way: where two of a queue go the same way
constexpr float slack_m = 1e-4f;     // by which a move may exceed its share
constexpr float end_reach_m = 0.3f;  // of a way that leads to no goal

// Ramps up to the first slow nobody, slopes from the second on are stairs; in between the share is interpolated.
constexpr float ramp = 0.1f, stairs = 0.45f;
constexpr float slope_way_m = 0.5f;  // over which a slope is averaged

// People climb stairs at 0.610 m/s and descend them at 0.694 m/s over the ground, and walk at 1.34 m/s on the level
// (Weidmann 1993): the defaults of `climbing` and `descending` are these shares.
float share_on(float slope, const clq_walkers_def &def)
{
    const float steep = std::clamp((std::fabs(slope) - ramp) / (stairs - ramp), 0.0f, 1.0f);
    return 1 - steep * (1 - (slope > 0 ? def.climbing : def.descending));
}

// A walker that is held up may be beside the polygons of its way, and others lead on from there.
constexpr uint64_t look_again_ticks = 10;

// A turn is no wider than its corner is far: a walker that is faster circles about a corner that it cannot reach.
constexpr float reached_m = 0.05f;

// A walker that has crept for 1.5 s (wide_m grows by widening_m_s) passes an opening at this speed at most. Otherwise
// crowds with preferred speeds up to 1.9 m/s pass doors of 1 and 2 m faster than measured.
constexpr float jammed_m = 1, passing_m_s = 1.1f, opening_reach_m = 1;

float between(const float *a, const Float3 &b) { return length_of(a[0] - b[0], a[2] - b[2]); }

}  // namespace

void Walkers::step()
{
    const std::lock_guard<std::mutex> lock(mesh_.lock);
    if (all_published_) pieces_.clear();
    else publish();
    see_doors();
    plan_ways();
    const auto each = [&](auto &&use) {
        for (uint32_t i = 0; i < bodies_.size(); ++i)
            if (bodies_[i].used()) use(i);
    };
    if (mesh_.has_byways) each([&](uint32_t i) { keep_to_byways(i); });
    each([&](uint32_t i) { make_room(i); });
    each([&](uint32_t i) { look_along(i); });
    fill_cells();
    each([&](uint32_t i) { see_bodies(i), see_walls(i); });
    each([&](uint32_t i) { steer(i); });
    give_way();
    each([&](uint32_t i) { move(i); });
    each([&](uint32_t i) { turn_shoulders(i); });
    ++ticks_;
    each([&](uint32_t i) { look_round(i), record(i); });
    all_published_ = false;
    publish();
}

// Where its way leads: past the corners that it is at, and wide of the next one, so that it does not scrape the wall.
void Walkers::look_along(uint32_t i)
{
    dtCrowdAgent &a = agent(i);
    Body &body = bodies_[i];
    Wish &wish = scratch_.wishes[i];
    wish = Wish();
    wish.time_gap_s = def_.time_gap_s;
    const float speed = length_of(a.vel[0], a.vel[2]);
    if (speed > still_m_s) wish.speed_now = speed, wish.heading = {a.vel[0] / speed, a.vel[2] / speed};
    if (body.state != CLQ_WALKER_WALKS || a.targetState != DT_CROWDAGENT_TARGET_VALID) return;
    if (speed < held_up * body.speed && (ticks_ + i) % look_again_ticks == 0)
        a.corridor.optimizePathTopology(mesh_.query.get(), filter(a));
    float corners[3 * max_corners];
    unsigned char flags[max_corners];
    dtPolyRef polygons[max_corners];
    const int count = a.corridor.findCorners(corners, flags, polygons, max_corners, mesh_.query.get(), filter(a));
    a.ncorners = std::min(count, DT_CROWDAGENT_MAX_CORNERS);
    std::copy(corners, corners + 3 * a.ncorners, a.cornerVerts);
    if (count == 0) return;
    a.corridor.optimizePathVisibility(a.cornerVerts + 3 * std::min(1, a.ncorners - 1), a.params.pathOptimizationRange,
                                      mesh_.query.get(), filter(a));
    const bool creeps = speed > still_m_s && speed < held_up * body.speed;
    const float rate = creeps ? widening_m_s : -widening_m_s;
    body.wide_m = std::clamp(body.wide_m + rate * static_cast<float>(def_.tick_s), 0.0f, widest_m);
    Flat here;
    float first_m = 0, bends = 0;
    for (int k = 0; k < count; ++k) {
        const Flat corner = {corners[3 * k] - a.npos[0], corners[3 * k + 2] - a.npos[2]};
        const Flat leg = {corner.x - here.x, corner.z - here.z};
        const float leg_m = length_of(leg);
        if (!(first_m > passed_m)) {
            wish.direction = corner;
            if (k + 1 < count) {
                const Flat next = {corners[3 * k + 3] - a.npos[0], corners[3 * k + 5] - a.npos[2]};
                const Flat in = unit(corner), out = unit({next.x - corner.x, next.z - corner.z});
                const Flat wide = {in.x - out.x, in.z - out.z};
                const float bend = length_of(wide);
                bends = bend;
                if (bend > 0.01f) {
                    const Flat outwards = {wide.x / bend, wide.z / bend};
                    const float by = wide_m + (bend > sharp ? room_at(i, polygons[k], corners + 3 * k, outwards) : 0);
                    wish.direction = {corner.x + by * outwards.x, corner.z + by * outwards.z};
                }
            }
            first_m = length_of(wish.direction);
        }
        if (leg_m > 0 && wish.left_m < onward_m) {
            const float share = std::min(1.0f, (onward_m - wish.left_m) / leg_m);
            wish.onward = {here.x + leg.x * share, here.z + leg.z * share};
        }
        wish.left_m += leg_m;
        here = corner;
        wish.corner_count = std::min(wish.corner_count + 1, max_shared);
        wish.corners[static_cast<size_t>(wish.corner_count - 1)] = {{corners[3 * k], corners[3 * k + 2]}, wish.left_m};
    }
    // Beyond the last corner that is known, as the crow flies.
    wish.left_m +=
        length_of(a.corridor.getTarget()[0] - a.npos[0] - here.x, a.corridor.getTarget()[2] - a.npos[2] - here.z);
    if (!(first_m > 0)) return;
    wish.direction = unit(wish.direction);
    wish.onward = length_of(wish.onward) > 0.01f ? unit(wish.onward) : wish.direction;
    wish.speed = body.speed * share_on(body.slope, def_);
    if (speed > still_m_s) {
        const bool looks_back = dot(wish.heading, wish.direction) < 0;
        const float aside = looks_back ? 1 : std::fabs(cross(wish.heading, wish.direction));
        const float turn = std::max(bends, 2 * aside);
        if (turn > sharp)
            wish.speed = std::min(wish.speed, std::sqrt(a.params.maxAcceleration * (first_m + reached_m) / turn));
    }
    wish.in_sight_m = INFINITY;
    if (count > 1 || !(flags[0] & DT_STRAIGHTPATH_END)) return;
    wish.in_sight_m = first_m;
    wish.speed *= std::min(1.0f, first_m / (2 * a.params.radius));
}

// How much wider it may go round a corner.
float Walkers::room_at(uint32_t i, dtPolyRef polygon, const float *corner, Flat outwards)
{
    const Body &body = bodies_[i];
    if (!(body.wide_m > 0)) return 0;
    const float reach = body.wide_m + opposite_m,
                end[3] = {corner[0] + reach * outwards.x, corner[1], corner[2] + reach * outwards.z};
    float share = 0, normal[3];
    dtPolyRef passed[max_corners];
    int count = 0;
    if (dtStatusFailed(
            mesh_.query->raycast(polygon, corner, end, filter(agent(i)), &share, normal, passed, &count, max_corners)))
        return 0;
    return std::clamp(std::min(share, 1.0f) * reach - opposite_m, 0.0f, body.wide_m);
}

void Walkers::steer(uint32_t i)
{
    dtCrowdAgent &a = agent(i);
    Wish &wish = scratch_.wishes[i];
    if (wish.speed > passing_m_s && bodies_[i].wide_m > jammed_m && is_narrow(i, wish.direction, opening_reach_m))
        wish.speed = passing_m_s;
    Flat v;
    if (a.targetState == DT_CROWDAGENT_TARGET_VELOCITY) v = {a.targetPos[0], a.targetPos[2]};
    else if (wish.speed > 0) v = choose_velocity(wish, scratch_.around[i]);
    if (stays(i)) a.vel[0] = a.vel[2] = 0;
    const Flat change = {v.x - a.vel[0], v.z - a.vel[2]};
    const float most = a.params.maxAcceleration * static_cast<float>(def_.tick_s), length = length_of(change);
    if (length > most) v = {a.vel[0] + change.x * most / length, a.vel[2] + change.z * most / length};
    a.dvel[0] = v.x, a.dvel[1] = 0, a.dvel[2] = v.z;
}

// A move that the ground bends is kept only if it leaves the others their shares.
void Walkers::move(uint32_t i)
{
    dtCrowdAgent &a = agent(i);
    const auto tick_s = static_cast<float>(def_.tick_s);
    const Surroundings &around = scratch_.around[i];
    const Flat by = keep_apart({a.dvel[0] * tick_s, a.dvel[2] * tick_s}, around);
    std::fill(a.vel, a.vel + 3, 0.0f);
    if (by.x == 0 && by.z == 0) return;
    const Float3 from = {a.npos[0], a.npos[1], a.npos[2]}, to = {from[0] + by.x, from[1], from[2] + by.z};
    a.corridor.movePosition(to.data(), mesh_.query.get(), filter(a));
    const Flat made = {a.corridor.getPos()[0] - from[0], a.corridor.getPos()[2] - from[2]};
    const bool keeps_apart = std::all_of(around.begin(), around.end(), [&](const Near &other) {
        return dot(made, other.at) <= (std::max(0.0f, other.gap() * other.share) + slack_m) * other.distance;
    });
    if (!keeps_apart) a.corridor.movePosition(from.data(), mesh_.query.get(), filter(a));
    std::copy(a.corridor.getPos(), a.corridor.getPos() + 3, a.npos);
    Body &body = bodies_[i];
    if (const float way_m = length_of(a.npos[0] - from[0], a.npos[2] - from[2]); way_m > 0)
        body.slope += std::min(1.0f, way_m / slope_way_m) * ((a.npos[1] - from[1]) / way_m - body.slope);
    a.vel[0] = (a.npos[0] - from[0]) / tick_s, a.vel[2] = (a.npos[2] - from[2]) / tick_s;
}

// Arrivals, and the end of a stay in a closed door.
void Walkers::look_round(uint32_t i)
{
    Body &body = bodies_[i];
    dtCrowdAgent &a = agent(i);
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
