// Bodies that press to a door from all sides can stand in an arch, each held by two others. A strict order opens it: a
// body gives way to a body of the same direction that is nearer to the door. It goes back, with the bodies behind it.
#include <algorithm>

#include "lib/stage/walk/walkers.h"

namespace claque::walk
{

namespace
{

constexpr float retreat_m_s = 0.25f;   // of one that goes back
constexpr float hold_m = 0.05f;        // a body so near holds another up
constexpr float held_up_share = 0.3f;  // share of its speed: a walker that makes less is held up

}  // namespace

// Where a walker that is held up wants to go; 0: it is not held up.
Flat Walkers::held_up_towards(uint32_t i) const
{
    const dtCrowdAgent &a = agent(i);
    const Wish &wish = scratch_.wishes[i];
    const Flat wanted = times({a.dvel[0], a.dvel[2]}, static_cast<float>(def_.tick_s));
    const float length = length_of(wanted);
    Flat towards = wish.direction;
    if (length > 0) {
        towards = times(wanted, 1 / length);
        const float made = dot(keep_apart(wanted, scratch_.around[i]), towards);
        if (made > held_up_share * length && wish.speed_now > still_m_s) return {};
    } else if (wish.speed_now > still_m_s) return {};
    const Flat along = keep_off_walls(towards, scratch_.around[i]);
    return length_of(along) > 1e-3f ? unit(along) : towards;
}

// Pushes that go back to one who stands before others replace those of a queue.
void Walkers::push_back(uint32_t k, Flat away, bool firmly)
{
    Push &push = scratch_.pushes[k];
    if (push.firmly && !firmly) return;
    if (firmly && !push.firmly) push.away = {};
    if (!push.listed) scratch_.pushed.push_back(k);
    push.away.x += away.x, push.away.z += away.z;
    push.firmly = firmly, push.listed = true;
}

void Walkers::give_way()
{
    std::vector<uint32_t> &order = scratch_.order;
    order.clear(), scratch_.pushed.clear();
    for (uint32_t i = 0; i < bodies_.size(); ++i) {
        scratch_.pushes[i] = {};
        if (bodies_[i].used() && scratch_.wishes[i].speed > 0) order.push_back(i);
    }
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        const float left_a = scratch_.wishes[a].left_m, left_b = scratch_.wishes[b].left_m;
        return left_a != left_b ? left_a < left_b : a < b;
    });
    for (const uint32_t i : order)
        if (!scratch_.pushes[i].listed) push_those_before(i);
    for (size_t n = 0; n < scratch_.pushed.size(); ++n) push_those_behind(scratch_.pushed[n]);
}

void Walkers::push_those_before(uint32_t i)
{
    const Flat towards = held_up_towards(i);
    if (towards.x == 0 && towards.z == 0) return;
    const bool goes = agent(i).dvel[0] != 0 || agent(i).dvel[2] != 0;
    for (const Near &other : scratch_.around[i]) {
        // Two that meet and both stand: the one that came later goes back.
        const bool meets = other.opposes && other.index > i && length_of(other.velocity) < 2 * still_m_s;
        if (!(meets || (goes && other.gives_way)) || other.gap() > hold_m || !(other.distance > 0)) continue;
        if (dot(other.direction(), towards) >= 0.01f) push_back(other.index, other.direction(), meets);
    }
}

void Walkers::push_those_behind(uint32_t i)
{
    const Push &push = scratch_.pushes[i];
    const Flat away = unit(push.away);
    dtCrowdAgent &a = agent(i);
    a.dvel[0] = away.x * retreat_m_s, a.dvel[2] = away.z * retreat_m_s;
    const bool firmly = push.firmly;
    for (const Near &other : scratch_.around[i]) {
        if (!(other.gives_way || firmly) || other.stays || other.gap() > hold_m || !(other.distance > 0)) continue;
        if (scratch_.pushes[other.index].listed) continue;
        if (dot(other.direction(), away) >= (firmly ? 0.3f : 0.01f)) push_back(other.index, other.direction(), firmly);
    }
}

}  // namespace claque::walk
