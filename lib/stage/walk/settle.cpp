// Walkers that leave the ground for a place beside it, such as a seat, and come back.
#include <algorithm>
#include <cmath>

#include "lib/stage/walk/walkers.h"

namespace claque::walk
{

namespace
{

constexpr double to_s = 1.0, from_s = 0.8;  // that it takes

double eased(double t) { return t * t * (3 - 2 * t); }

}  // namespace

void Walkers::settle(clq_walker id, const double place[3])
{
    Body &body = bodies_[index_of(id)];
    if (body.pull == Body::Pull::to) return;
    body.pull = Body::Pull::to;
    body.pull_s = time_s();
    std::copy(place, place + 3, body.beside);
}

bool Walkers::has_settled(clq_walker id) const
{
    const Body &body = bodies_[index_of(id)];
    return body.pull == Body::Pull::to && time_s() >= body.pull_s + to_s;
}

void Walkers::rise_from(clq_walker id, const double place[3])
{
    Body &body = bodies_[index_of(id)];
    body.pull = Body::Pull::from;
    body.pull_s = time_s();
    std::copy(place, place + 3, body.beside);
    if (!body.points.empty()) std::copy(place, place + 3, body.points.back().position);
}

// Of a walker that gets another goal: it comes back from where it is on its way beside the ground.
void Walkers::return_to_ground(Body &body) const
{
    if (body.pull != Body::Pull::to) return;
    const double done = std::min((time_s() - body.pull_s) / to_s, 1.0);
    body.pull = Body::Pull::from;
    body.pull_s = time_s() - (1 - done) * from_s;
}

// Where a walker is shown that is at a place of the mesh.
void Walkers::show(uint32_t i, const float *place, double time_s, double out[3]) const
{
    mesh_.world(place, out);
    const Body &body = bodies_[i];
    if (body.pull == Body::Pull::none) return;
    const bool goes_to = body.pull == Body::Pull::to;
    const double done = std::clamp((time_s - body.pull_s) / (goes_to ? to_s : from_s), 0.0, 1.0);
    const double share = goes_to ? eased(done) : 1 - eased(done);
    for (int k = 0; k < 3; ++k) out[k] += (body.beside[k] - out[k]) * share;
}

}  // namespace claque::walk
