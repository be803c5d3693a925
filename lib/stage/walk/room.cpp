// Standing walkers make room for walkers that cannot pass, and take their places again. A walker goes round
// standing ones but moves none of these: in a gap both would wait for ever.
#include <algorithm>
#include <cmath>

#include "lib/stage/walk/walkers.h"

namespace claque::walk
{

namespace
{

constexpr float look_m = 1.5f;     // a walker that comes so near makes others give room
constexpr float touch_m = 0.15f;   // gap between bodies: a body that steps aside moves bodies so near
constexpr float margin_m = 0.06f;  // gap between bodies that pass
constexpr float hampered = 0.7f;   // share of its speed: a walker that makes less cannot pass
constexpr float stuck = 0.1f;      // the same where there seems to be room
constexpr float any_speed = 1e9f;
constexpr float left_m = 0.2f;       // so far from its place a walker goes back to it
constexpr float there_m = 0.05f;     // until it is so near
constexpr float forgotten_m = 4.0f;  // a place so far away is not looked for
// A walker that makes room is faster than one that goes back, which moves no others.
constexpr float aside_m_s = 0.7f, back_m_s = 0.45f;

bool is_moved(const dtCrowdAgent &a) { return a.targetState == DT_CROWDAGENT_TARGET_VELOCITY; }

bool makes_room(const dtCrowdAgent &a)
{
    return is_moved(a) && length_of(a.targetPos[0], a.targetPos[2]) > (aside_m_s + back_m_s) / 2;
}

}  // namespace

// Where walker k wants to go at this place, if it wants to pass there and cannot: the direction, of length 1, how far
// ahead of it the place is, and how far to its side (positive: left of it when seen from above with x to the right and
// z down).
bool Walkers::wants_to_pass(uint32_t k, const Float3 &place, float radius, float slower_than, Passing &out) const
{
    const Body &body = bodies_[k];
    const dtCrowdAgent &a = agent(k);
    const bool walks = body.state == CLQ_WALKER_WALKS && !is_moved(a);
    float x = body.aim[0], z = body.aim[1], look = look_m;
    if (!walks) {
        if (!makes_room(a)) return false;
        const float speed = length_of(a.targetPos[0], a.targetPos[2]);
        x = a.targetPos[0] / speed, z = a.targetPos[2] / speed, look = touch_m + radius + a.params.radius;
    }
    if (x == 0 && z == 0) return false;
    const float dx = place[0] - a.npos[0], dz = place[2] - a.npos[2], bodies = radius + a.params.radius;
    out = {x, z, dx * x + dz * z, dx * z - dz * x};
    if (!(out.ahead > 0 && out.ahead < look && std::fabs(out.aside) < bodies + margin_m)) return false;
    if (!walks) return true;
    if (a.vel[0] * x + a.vel[2] * z > slower_than * body.speed) return false;
    return length_of(place[0] - body.goal[0], place[2] - body.goal[2]) > body.near_m + bodies;  // else it arrives there
}

// How far a walker can go in a direction before a wall, `reach` at most.
float Walkers::room_towards(uint32_t i, float x, float z, float reach) const
{
    const dtCrowdAgent &a = agent(i);
    const Float3 end = {a.npos[0] + reach * x, a.npos[1], a.npos[2] + reach * z};
    const dtQueryFilter &filter = *crowd_->getFilter(a.params.queryFilterType);
    float share = 0, normal[3];
    int count = 0;
    if (dtStatusFailed(mesh_.query->raycast(a.corridor.getFirstPoly(), a.npos, end.data(), &filter, &share, normal,
                                            nullptr, &count, 0)))
        return 0;
    return reach * std::min(share, 1.0f);
}

// Whether there is room for another beside a walker, right or left of it as the other one comes.
bool Walkers::one_can_go_round(uint32_t i, const Passing &passing, float bodies) const
{
    const dtCrowdAgent &a = agent(i);
    const float wanted = bodies + margin_m;
    for (const float side : {1.0f, -1.0f}) {
        const float x = side * passing.z, z = -side * passing.x;
        bool is_free = room_towards(i, x, z, wanted) >= wanted;
        for (int n = 0; n < a.nneis && is_free; ++n) {
            const auto k = static_cast<uint32_t>(a.neis[n].idx);
            if (k >= bodies_.size() || !rests(bodies_[k])) continue;
            const float *at = agent(k).npos;
            is_free = length_of(at[0] - a.npos[0] - wanted * x, at[2] - a.npos[2] - wanted * z) > bodies;
        }
        if (is_free) return true;
    }
    return false;
}

// To the side where there is room for both; ahead of the other one where there is none.
void Walkers::step_aside(uint32_t i, const Passing &passing, float bodies)
{
    const float wanted = bodies + margin_m, to_left = wanted - passing.aside, to_right = wanted + passing.aside;
    const float x = passing.z, z = -passing.x;  // to its left
    const float left = room_towards(i, x, z, wanted + std::fabs(passing.aside));
    const float right = room_towards(i, -x, -z, wanted + std::fabs(passing.aside));
    float velocity[3] = {passing.x * aside_m_s, 0, passing.z * aside_m_s};
    if (left + right >= wanted) {
        bool goes_left = std::fabs(passing.aside) > 0.02f ? passing.aside > 0 : left >= right;
        if (goes_left && left < to_left && right >= to_right) goes_left = false;
        else if (!goes_left && right < to_right && left >= to_left) goes_left = true;
        velocity[0] = (goes_left ? x : -x) * aside_m_s, velocity[2] = (goes_left ? z : -z) * aside_m_s;
    }
    crowd_->requestMoveVelocity(static_cast<int>(i), velocity);
}

void Walkers::make_room(uint32_t i)
{
    Body &body = bodies_[i];
    dtCrowdAgent &a = agent(i);
    const bool walks = body.state == CLQ_WALKER_WALKS || body.state == CLQ_WALKER_WAITS;
    if (walks || body.pull == Body::Pull::to) return;
    const bool moved = is_moved(a), went_back = moved && !makes_room(a);
    const Float3 place = {a.npos[0], a.npos[1], a.npos[2]};
    if (moved) crowd_->resetMoveTarget(static_cast<int>(i));
    for (int n = 0; n < a.nneis; ++n) {
        const auto k = static_cast<uint32_t>(a.neis[n].idx);
        Passing passing{};
        if (k >= bodies_.size() || !bodies_[k].used()) continue;
        if (!wants_to_pass(k, place, a.params.radius, moved ? any_speed : hampered, passing)) continue;
        const float bodies = a.params.radius + agent(k).params.radius;
        const bool waits = !moved && one_can_go_round(i, passing, bodies);
        if (waits && !wants_to_pass(k, place, a.params.radius, stuck, passing)) continue;
        return step_aside(i, passing, bodies);
    }
    if (rests(body)) go_back(i, went_back);
}

// To the place where it stood, unless it is taken or in the way of another. A place that it does not get to is no
// longer its own.
void Walkers::go_back(uint32_t i, bool went_back)
{
    Body &body = bodies_[i];
    const dtCrowdAgent &a = agent(i);
    const float x = body.end[0] - a.npos[0], z = body.end[2] - a.npos[2], distance = length_of(x, z);
    if (distance < (went_back ? there_m : left_m)) return;
    const float made = (a.vel[0] * x + a.vel[2] * z) / distance;
    if (made < -there_m) return;  // it still makes room
    bool hindered = went_back && made < back_m_s / 5;
    for (int n = 0; n < a.nneis; ++n) {
        const auto k = static_cast<uint32_t>(a.neis[n].idx);
        if (k >= bodies_.size() || !bodies_[k].used()) continue;
        const dtCrowdAgent &other = agent(k);
        const float bodies = a.params.radius + other.params.radius;
        Passing passing{};
        if (length_of(body.end[0] - other.npos[0], body.end[2] - other.npos[2]) < bodies) return;
        if (wants_to_pass(k, body.end, a.params.radius, any_speed, passing)) return;
        if (bodies_[k].state == CLQ_WALKER_WALKS) hindered = false;  // it will be gone
    }
    if (hindered || distance > forgotten_m) {
        body.end = {a.npos[0], a.npos[1], a.npos[2]};
        return;
    }
    const float velocity[3] = {x * back_m_s / distance, 0, z * back_m_s / distance};
    crowd_->requestMoveVelocity(static_cast<int>(i), velocity);
}

// Whether walkers that stand at its goal keep it from coming nearer.
bool Walkers::others_are_there(uint32_t i) const
{
    const Body &body = bodies_[i];
    const dtCrowdAgent &a = agent(i);
    const auto to_goal = [&](const float *from) { return length_of(from[0] - body.goal[0], from[2] - body.goal[2]); };
    for (int n = 0; n < a.nneis; ++n) {
        const auto k = static_cast<uint32_t>(a.neis[n].idx);
        if (k >= bodies_.size() || !bodies_[k].used() || !rests(bodies_[k])) continue;
        const dtCrowdAgent &other = agent(k);
        const float gap =
            length_of(other.npos[0] - a.npos[0], other.npos[2] - a.npos[2]) - a.params.radius - other.params.radius;
        const bool between = gap < touch_m && to_goal(other.npos) < to_goal(a.npos);
        const bool there = to_goal(other.npos) <= body.near_m + other.params.radius;
        const bool same_goal = bodies_[k].state == CLQ_WALKER_ARRIVED && to_goal(bodies_[k].goal.data()) <= body.near_m;
        if (between && (there || same_goal)) return true;
    }
    return false;
}

}  // namespace claque::walk
