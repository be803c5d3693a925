// The bodies and walls round each walker.
#include <algorithm>
#include <cmath>

#include "lib/stage/walk/walkers.h"

namespace claque::walk
{

namespace
{

constexpr float sight_m = 2.5f, room_m = 1.9f;       // of bodies: at least, and beyond two of the widest
constexpr float storey_m = 1.5f;                     // bodies so far above each other are on different floors
constexpr float walls_m = 2.0f;                      // of walls
constexpr float opposite = -0.5f, same_way = -0.2f;  // cosines between two ways

// The nearest point of a wall, from a walker in front of it.
bool face(Wall &wall)
{
    const Flat along = {wall.to.x - wall.from.x, wall.to.z - wall.from.z};
    const float length = length_of(along);
    if (!(length > 1e-4f)) return false;
    wall.outside = {-along.z / length, along.x / length};
    wall.distance = dot(wall.from, wall.outside);
    if (wall.distance < -1e-3f) return false;  // the walker is behind it
    wall.distance = std::max(0.0f, wall.distance);
    const float t = -dot(wall.from, along);
    if (t > 0 && t < length * length) return true;
    const Flat end = t > 0 ? wall.to : wall.from;
    wall.distance = length_of(end);
    wall.outside = unit(end);
    return wall.distance > 1e-3f;
}

}  // namespace

float Walkers::sight() const { return std::max(sight_m, 2 * def_.max_radius_m + room_m); }

void Walkers::fill_cells()
{
    scratch_.places.clear();
    for (uint32_t i = 0; i < bodies_.size(); ++i)
        if (bodies_[i].used()) scratch_.places.push_back({i, agent(i).npos[0], agent(i).npos[2]});
    scratch_.cells.fill(scratch_.places, sight());
}

// Neither goes on, nor is pushed by others.
bool Walkers::stays(uint32_t i) const
{
    const dtCrowdAgent &a = agent(i);
    const bool goes = bodies_[i].state == CLQ_WALKER_WALKS || a.targetState == DT_CROWDAGENT_TARGET_VELOCITY;
    return !goes && length_of(a.vel[0], a.vel[2]) <= still_m_s;
}

// Walkers of one direction give way by distance: the farther one from the first corner of both ways, or from the goal
// where the ways share no corner.
bool Walkers::gives_way(uint32_t k, uint32_t i) const
{
    const Wish &other = scratch_.wishes[k], &own = scratch_.wishes[i];
    if (!(other.speed > 0) || !(own.speed > 0) || dot(other.onward, own.onward) < same_way) return false;
    for (int a = 0; a < own.corner_count; ++a)
        for (int b = 0; b < other.corner_count; ++b) {
            const Corner &mine = own.corners[static_cast<size_t>(a)], &its = other.corners[static_cast<size_t>(b)];
            if (mine.at.x != its.at.x || mine.at.z != its.at.z) continue;
            return its.left_m > mine.left_m || (its.left_m == mine.left_m && k > i);
        }
    return other.left_m > own.left_m || (other.left_m == own.left_m && k > i);
}

Near Walkers::near_of(uint32_t i, uint32_t k) const
{
    const dtCrowdAgent &a = agent(i), &other = agent(k);
    Near near;
    near.index = k;
    near.at = {other.npos[0] - a.npos[0], other.npos[2] - a.npos[2]}, near.velocity = {other.vel[0], other.vel[2]};
    near.distance = length_of(near.at), near.bodies = breadth(i) + breadth(k);
    near.stays = stays(k);
    near.share = near.stays ? 1 : 0.5f;
    return near;
}

void Walkers::see_bodies(uint32_t i)
{
    Surroundings &around = scratch_.around[i];
    dtCrowdAgent &a = agent(i);
    around.near_count = 0, around.meets = false;
    const float far = sight();
    around.unseen_gap = far - breadth(i) - def_.max_radius_m;
    scratch_.cells.each(a.npos[0], a.npos[2], far, [&](const Cells::Place &place) {
        const float x = place.x - a.npos[0], z = place.z - a.npos[2];
        if (place.index == i || x * x + z * z > far * far) return;
        if (std::fabs(agent(place.index).npos[1] - a.npos[1]) > storey_m) return;
        const Near near = near_of(i, place.index);
        Near *const first = around.near.data();
        Near *at = std::upper_bound(first, first + around.near_count, near,
                                    [](const Near &one, const Near &other) { return one.gap() < other.gap(); });
        if (around.near_count == max_near)
            around.unseen_gap = std::min(around.unseen_gap, std::max(near.gap(), first[max_near - 1].gap()));
        else ++around.near_count;
        if (at == first + max_near) return;
        std::move_backward(at, first + around.near_count - 1, first + around.near_count);
        *at = near;
    });
    const Wish &own = scratch_.wishes[i];
    for (int n = 0; n < around.near_count; ++n) {
        Near &near = around.near[static_cast<size_t>(n)];
        const Wish &other = scratch_.wishes[near.index];
        near.gives_way = gives_way(near.index, i);
        near.opposes = other.speed > 0 && dot(other.onward, own.onward) < opposite;
        around.meets = around.meets || near.opposes;
    }
    a.nneis = std::min(around.near_count, DT_CROWDAGENT_MAX_NEIGHBOURS);
    for (int k = 0; k < a.nneis; ++k) {
        const Near &near = around.near[static_cast<size_t>(k)];
        a.neis[k] = {static_cast<int>(near.index), near.distance};
    }
}

void Walkers::see_walls(uint32_t i)
{
    Surroundings &around = scratch_.around[i];
    dtCrowdAgent &a = agent(i);
    a.boundary.update(a.corridor.getFirstPoly(), a.npos, walls_m, mesh_.query.get(), filter(a));
    around.wall_count = 0;
    for (int k = 0; k < a.boundary.getSegmentCount() && around.wall_count < max_walls; ++k) {
        const float *s = a.boundary.getSegment(k);
        Wall &wall = around.walls[static_cast<size_t>(around.wall_count)];
        wall.from = {s[0] - a.npos[0], s[2] - a.npos[2]}, wall.to = {s[3] - a.npos[0], s[5] - a.npos[2]};
        if (face(wall)) ++around.wall_count;
    }
}

}  // namespace claque::walk
