// A walker that oncoming walkers hold up turns its shoulders: it takes less room, and both pass. It turns back when it
// walks or rests, and has room.
#include <algorithm>

#include "lib/stage/walk/walkers.h"

namespace claque::walk
{

namespace
{

// Chosen with the constants of steer.cpp, by counterflow of two people a square metre.
constexpr float held_up_m_s = 0.15f, turns_s = 0.6f, walks_again_m_s = 0.4f;

}  // namespace

float Walkers::breadth(uint32_t i) const { return agent(i).params.radius * bodies_[i].shoulders; }

// One after the other: what one takes is gone for the next.
void Walkers::turn_shoulders(uint32_t i)
{
    Body &body = bodies_[i];
    const dtCrowdAgent &a = agent(i);
    const float speed = length_of(a.vel[0], a.vel[2]);
    const bool goes = scratch_.wishes[i].speed > 0;
    const float onward = dot({a.vel[0], a.vel[2]}, scratch_.wishes[i].direction);
    const bool is_held_up = goes && scratch_.around[i].meets && onward < held_up_m_s;
    const auto tick_s = static_cast<float>(def_.tick_s);
    body.held_up_s = std::clamp(body.held_up_s + (is_held_up ? tick_s : -tick_s), 0.0f, waits_long_s);
    if (body.held_up_s >= turns_s) body.shoulders = turned_shoulders;
    if (!(body.shoulders < 1) || (goes && speed < walks_again_m_s)) return;
    for (const Near &near : scratch_.around[i]) {
        const dtCrowdAgent &other = agent(near.index);
        const float distance = length_of(other.npos[0] - a.npos[0], other.npos[2] - a.npos[2]);
        if (distance < a.params.radius + breadth(near.index)) return;
    }
    body.shoulders = 1;
}

}  // namespace claque::walk
