// Pieces of tracks about what walkers did.
#include <algorithm>
#include <cmath>
#include <new>

#include "lib/stage/walk/walkers.h"

namespace claque::walk
{

namespace
{

constexpr double ahead_s = 1;  // guessed behind the end of a piece
constexpr double guess_step_s = 0.1;
constexpr int straight_steps = 2;  // first it goes on as it moves now, among others not along its way
constexpr double kept_before_s = 2;

}  // namespace

void Walkers::publish()
{
    for (uint32_t i = 0; i < bodies_.size(); ++i) {
        Body &body = bodies_[i];
        if (!body.used() || !body.locomotion) continue;
        // Each at a tick of its own, so that no tick makes all pieces.
        const bool due = ticks_ % def_.piece_ticks == body.border;
        if (due && time_s() - body.piece_end_s > min_piece_s) publish(i);
    }
    all_published_ = true;
}

void Walkers::publish(uint32_t i)
{
    Body &body = bodies_[i];
    const size_t known = body.points.size();
    guess(i, body.points);
    // Known headings of a rest would be those of all of the piece; a walker looks where it goes.
    if (!rests(body))
        for (clq_track_point &point : body.points) point.heading_rad = NAN;
    clq_track_def def = clq_track_def_init();
    def.points = body.points.data(), def.point_count = static_cast<uint32_t>(body.points.size());
    def.smooth_s = def_.smooth_s;
    def.metres_per_unit = static_cast<float>(mesh_.metres_per_unit);
    def.scale = body.scale;
    def.seed = body.seed;
    def.previous = body.piece.get();
    def.end_s = time_s();
    def.ground = def_.ground, def.ground_user = def_.ground_user;
    clq_track *made = nullptr;
    const clq_status status = clq_track_create(body.locomotion, &def, &made);
    body.points.resize(known);
    if (status == CLQ_OUT_OF_MEMORY) throw std::bad_alloc();
    if (status != CLQ_OK) fail(status, "the track of walker %u: %s", i + 1, clq_last_error());
    body.piece.reset(made);
    pieces_.push_back({id_of(i), made, body.piece_end_s, time_s()});
    body.piece_end_s = time_s();
    ++published_;
    const double from_s = time_s() - kept_before_s;
    const auto old = [&](const clq_track_point &p) { return p.time_s < from_s; };
    body.points.erase(body.points.begin(), std::find_if_not(body.points.begin(), body.points.end() - 1, old));
}

// How the walker will go on, as far as it is known: in its direction, then along the next corners of its way. Its speed
// stays.
void Walkers::guess(uint32_t i, std::vector<clq_track_point> &points) const
{
    const dtCrowdAgent &a = agent(i);
    const bool walks =
        bodies_[i].state == CLQ_WALKER_WALKS && a.targetState == DT_CROWDAGENT_TARGET_VALID && a.ncorners > 0;
    const float speed = length_of(a.vel[0], a.vel[2]);
    Float3 at = {a.npos[0], a.npos[1], a.npos[2]};
    int corner = 0;
    int steps = 0;
    for (double t = guess_step_s; t <= ahead_s + 1e-9; t += guess_step_s) {
        float left = walks ? speed * static_cast<float>(guess_step_s) : 0;
        if (walks && steps++ < straight_steps) {
            at[0] += a.vel[0] * static_cast<float>(guess_step_s), at[2] += a.vel[2] * static_cast<float>(guess_step_s);
            left = 0;
        }
        while (left > 0 && corner < a.ncorners) {
            const float *to = a.cornerVerts + 3 * corner;
            const float x = to[0] - at[0], z = to[2] - at[2], distance = length_of(x, z);
            if (distance <= left) {
                at = {to[0], to[1], to[2]}, left -= distance, ++corner;
                continue;
            }
            at[0] += x * left / distance, at[2] += z * left / distance;
            at[1] += (to[1] - at[1]) * left / distance;
            left = 0;
        }
        clq_track_point point{};
        point.time_s = time_s() + t;
        show(i, at.data(), point.time_s, point.position);
        point.heading_rad = points.back().heading_rad;
        points.push_back(point);
    }
}

}  // namespace claque::walk
