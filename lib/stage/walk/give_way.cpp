// Bodies that press to a door from all sides can stand in an arch, each held by two others. A strict order opens it: a
// body gives way to a body of the same direction that is nearer to the door. It goes back, with the bodies behind it.
// Where two crowds meet in an opening, the walker that was added first goes first: walkers that it waits behind take
// its rank, as tasks inherit a priority (Sha, Rajkumar and Lehoczky 1990: Priority inheritance protocols), and the
// lowest rank presses on. In wide corridors lanes do better.
#include <algorithm>
#include <cmath>

#include "lib/stage/walk/walkers.h"

namespace claque::walk
{

namespace
{

constexpr float retreat_m_s = 0.25f;   // of one that goes back
constexpr float pressing_m_s = 0.5f;   // of one that presses on; slower ones wait
constexpr float hold_m = 0.05f;        // a body so near holds another up
constexpr float meets_m = 1;           // two of two directions that are so near can wait for each other
constexpr float narrow_m = 2.5f;       // the room of the middles of people in an opening of 2.9 m
constexpr float step_m = 0.25f;        // between the places at which the room is measured
constexpr float clears_m = 0.5f;       // so near, one of them goes back
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

bool Walkers::is_nearer(uint32_t a, uint32_t b) const
{
    const float left_a = scratch_.wishes[a].left_m, left_b = scratch_.wishes[b].left_m;
    return left_a != left_b ? left_a < left_b : a < b;
}

void Walkers::give_way()
{
    std::vector<uint32_t> &order = scratch_.order;
    order.clear();
    bool somebody_meets = false;
    for (uint32_t i = 0; i < bodies_.size(); ++i) {
        scratch_.pushes[i] = {};
        scratch_.ranks[i] = i;
        if (!bodies_[i].used() || !(scratch_.wishes[i].speed > 0)) continue;
        order.push_back(i);
        somebody_meets = somebody_meets || bodies_[i].held_up_s >= waits_s;
    }
    std::sort(order.begin(), order.end(), [this](uint32_t a, uint32_t b) { return is_nearer(a, b); });
    if (somebody_meets) press_on_by_rank();
    scratch_.pushed.clear();
    for (const uint32_t i : order)
        if (!scratch_.pushes[i].listed) push_those_before(i);
    push_on();
}

void Walkers::press_on_by_rank()
{
    std::vector<uint32_t> &by_rank = scratch_.by_rank, &ranks = scratch_.ranks;
    by_rank = scratch_.order;
    std::for_each(by_rank.rbegin(), by_rank.rend(), [this](uint32_t i) { pass_rank_on(i); });
    std::sort(by_rank.begin(), by_rank.end(),
              [&](uint32_t a, uint32_t b) { return ranks[a] != ranks[b] ? ranks[a] < ranks[b] : is_nearer(a, b); });
    for (const uint32_t i : by_rank)
        if (!scratch_.pushes[i].listed && bodies_[i].held_up_s >= waits_s) press_on(i);
}

// Walkers ahead inherit the rank of a walker that waits behind them.
void Walkers::pass_rank_on(uint32_t i)
{
    const Wish &wish = scratch_.wishes[i];
    if (wish.speed_now > pressing_m_s) return;
    for (const Near &other : scratch_.around[i]) {
        if (other.gap() > clears_m || !(dot(other.at, wish.direction) > 0) || !gives_way(i, other.index)) continue;
        scratch_.ranks[other.index] = std::min(scratch_.ranks[other.index], scratch_.ranks[i]);
    }
}

// Whether walls that face each other leave little room within `reach` in a direction.
bool Walkers::is_narrow(uint32_t i, Flat towards, float reach) const
{
    const dtCrowdAgent &a = agent(i);
    for (float ahead = -step_m; ahead < reach + step_m; ahead += step_m) {
        struct Seen {
            Flat outside;
            float distance;
        };
        std::array<Seen, max_walls> seen;
        size_t count = 0;
        for (int k = 0; k < a.boundary.getSegmentCount() && count < seen.size(); ++k) {
            const float *s = a.boundary.getSegment(k);
            const Flat from = {s[0] - a.npos[0] - ahead * towards.x, s[2] - a.npos[2] - ahead * towards.z},
                       along = {s[3] - s[0], s[5] - s[2]}, outside = unit({-along.z, along.x});
            const float squared = dot(along, along);
            if (!(squared > 0) || !(dot(from, outside) > 0)) continue;  // it is behind this wall
            const float part = std::clamp(-dot(from, along) / squared, 0.0f, 1.0f);
            const float distance = length_of({from.x + part * along.x, from.z + part * along.z});
            for (size_t n = 0; n < count; ++n)
                if (dot(seen[n].outside, outside) < -0.5f && seen[n].distance + distance < narrow_m) return true;
            seen[count++] = {outside, distance};
        }
    }
    return false;
}

// Walker i goes on against walkers of another direction, and they go back.
void Walkers::press_on(uint32_t i)
{
    scratch_.pushed.clear();
    bool meets = false;
    const Flat towards = unit(keep_off_walls(scratch_.wishes[i].direction, scratch_.around[i]));
    for (const Near &other : scratch_.around[i]) {
        if (other.gap() > meets_m || !(other.distance > 0) || scratch_.ranks[other.index] <= scratch_.ranks[i])
            continue;
        const Flat its = scratch_.wishes[other.index].direction;
        if (!(dot(other.at, towards) > 0) || !(dot(other.at, its) < 0)) continue;
        const float both_s = std::min(bodies_[i].held_up_s, bodies_[other.index].held_up_s);
        if (both_s < waits_s || other.gives_way || gives_way(i, other.index)) continue;
        if (both_s < waits_long_s && !is_narrow(i, other.direction(), other.distance)) continue;
        meets = true;
        if (other.gap() <= clears_m) push_back(other.index, other.direction(), true);
    }
    if (!meets) return;
    dtCrowdAgent &a = agent(i);
    a.dvel[0] = towards.x * pressing_m_s, a.dvel[2] = towards.z * pressing_m_s;
    scratch_.pushes[i].presses = true;
    push_on();
}

void Walkers::push_those_before(uint32_t i)
{
    if (scratch_.pushes[i].presses) return;
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

void Walkers::push_on()
{
    for (size_t n = 0; n < scratch_.pushed.size(); ++n) push_those_behind(scratch_.pushed[n]);
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
