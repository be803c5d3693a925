// Walkers as bytes. The crowd has no state besides what is here: its walls are looked up in each tick, its queue is
// empty.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>

#include "lib/stage/walk/walkers.h"

namespace claque::walk
{

namespace
{

using stage::bad_save;
using stage::number_of_enum;
using stage::numbers;

constexpr double max_clock_s = 1e12;

// Floats, every bit.
template <class Archive>
void floats(Archive &archive, float *values, int count)
{
    for (int k = 0; k < count; ++k) archive.number(values[k]);
}

template <class Archive>
void walk_agent(Archive &archive, dtCrowdAgent &a)
{
    numbers(archive, a.params.radius, a.params.maxAcceleration, a.params.queryFilterType, a.partial, a.targetState,
            a.targetRef);
    floats(archive, a.npos, 3);
    floats(archive, a.vel, 3);
    floats(archive, a.targetPos, 3);
    archive.number(a.nneis);
    if (a.nneis < 0 || a.nneis > DT_CROWDAGENT_MAX_NEIGHBOURS) bad_save("a walker has too many neighbours");
    for (int k = 0; k < a.nneis; ++k) numbers(archive, a.neis[k].idx, a.neis[k].dist);
}

void walk_piece(stage::SaveWriter &out, const HeldTrack &piece, const clq_locomotion *)
{
    std::vector<uint8_t> bytes;
    if (piece) bytes = bytes_of(piece.get());
    out.count(bytes.size(), 1);
    out.raw(bytes);
}

void walk_piece(stage::SaveReader &in, HeldTrack &piece, const clq_locomotion *locomotion)
{
    std::vector<uint8_t> bytes(in.count(0, 1));
    in.raw(bytes);
    piece.reset();
    if (bytes.empty()) return;
    if (!locomotion) bad_save("a walker without a gait has a track");
    piece = track_of(locomotion, bytes);
}

}  // namespace

std::vector<uint8_t> bytes_of(const clq_track *track)
{
    std::vector<uint8_t> bytes;
    const auto take = [](void *user, const void *from, size_t count) {
        auto &to = *static_cast<std::vector<uint8_t> *>(user);
        const auto *first = static_cast<const uint8_t *>(from);
        to.insert(to.end(), first, first + count);
        return 0;
    };
    if (clq_track_save(track, take, &bytes) != CLQ_OK) throw std::bad_alloc();
    return bytes;
}

HeldTrack track_of(const clq_locomotion *locomotion, const std::vector<uint8_t> &bytes)
{
    clq_track *made = nullptr;
    const clq_status status = clq_track_load(locomotion, bytes.data(), bytes.size(), &made);
    if (status == CLQ_OUT_OF_MEMORY) throw std::bad_alloc();
    if (status != CLQ_OK) stage::fail(CLQ_FORMAT, "the track of a saved walker: %s", clq_last_error());
    return HeldTrack(made);
}

template <class Archive>
void Walkers::walk_totals(Archive &archive)
{
    numbers(archive, ticks_, plans_, published_, next_plan_, count_);
    bool knows_doors = mesh_version_ == mesh_.version;
    archive.number(knows_doors);
    if (Archive::reads) mesh_version_ = knows_doors ? mesh_.version : 0;
    if (next_plan_ >= bodies_.size() || count_ > bodies_.size() || !(std::fabs(time_s()) < max_clock_s))
        bad_save("a number of walkers or ticks is impossible");
}

template <class Archive>
void Walkers::walk_body(Archive &archive, uint32_t i, const std::vector<const clq_locomotion *> &locomotions)
{
    Body &body = bodies_[i];
    dtCrowdAgent &a = agent(i);
    walk_agent(archive, a);
    number_of_enum(archive, body.state, CLQ_WALKER_BLOCKED);
    floats(archive, body.goal.data(), 3), floats(archive, body.end.data(), 3), floats(archive, body.aim, 2);
    numbers(archive, body.goal_ref, body.near_m, body.own_speed, body.speed, body.complete, body.cut, body.slope,
            body.wide_m, body.shoulders, body.held_up_s, body.heading_rad, body.scale, body.seed, body.piece_end_s,
            body.border);
    number_of_enum(archive, body.pull, Body::Pull::from);
    numbers(archive, body.beside[0], body.beside[1], body.beside[2], body.pull_s);
    auto number =
        static_cast<uint32_t>(std::find(locomotions.begin(), locomotions.end(), body.locomotion) - locomotions.begin());
    archive.number(number);
    if (number > locomotions.size()) bad_save("a walker has a gait that is not given");
    if (Archive::reads) body.locomotion = number < locomotions.size() ? locomotions[number] : nullptr;
    stage::list(archive, body.points, 36, [&](clq_track_point &point) {
        numbers(archive, point.time_s, point.position[0], point.position[1], point.position[2], point.heading_rad);
    });
    walk_piece(archive, body.piece, body.locomotion);
    std::vector<dtPolyRef> path(a.corridor.getPath(), a.corridor.getPath() + a.corridor.getPathCount());
    stage::list(archive, path, sizeof(dtPolyRef), [&](dtPolyRef &polygon) { archive.number(polygon); });
    Float3 target{};
    std::copy(a.corridor.getTarget(), a.corridor.getTarget() + 3, target.begin());
    floats(archive, target.data(), 3);
    if (Archive::reads) put_back(i, path, target.data());
}

void Walkers::put_back(uint32_t i, const std::vector<dtPolyRef> &path, const float *target)
{
    dtCrowdAgent &a = agent(i);
    if (path.empty() || path.size() > size_t(max_way_polys)) bad_save("a walker has a way of too few or many polygons");
    const auto exists = [&](dtPolyRef polygon) { return mesh_.nav->isValidPolyRef(polygon); };
    if (!std::all_of(path.begin(), path.end(), exists)) bad_save("a walker's way is on another ground");
    a.corridor.reset(path[0], a.npos);
    a.corridor.setCorridor(target, path.data(), static_cast<int>(path.size()));
    a.state = DT_CROWDAGENT_STATE_WALKING;
    a.params.pathOptimizationRange = 30 * a.params.radius;
    check_saved(i);
}

// What is read is what a crowd could have.
void Walkers::check_saved(uint32_t i) const
{
    const Body &body = bodies_[i];
    const dtCrowdAgent &a = agent(i);
    bool good = a.params.radius >= 0.05f && a.params.radius <= def_.max_radius_m && body.speed > 0 && body.speed <= 8 &&
                a.params.maxAcceleration > 0 && a.params.maxAcceleration <= 50 &&
                a.params.queryFilterType <= last_filter && body.near_m > 0 && body.scale > 0 &&
                std::fabs(body.slope) < 1000 && body.wide_m >= 0 && body.wide_m <= widest_m &&
                body.shoulders >= turned_shoulders && body.shoulders <= 1 && body.held_up_s >= 0;
    const bool no_way = a.targetState == DT_CROWDAGENT_TARGET_NONE || a.targetState == DT_CROWDAGENT_TARGET_VELOCITY;
    good = good && (no_way || a.targetState == DT_CROWDAGENT_TARGET_VALID);
    good = good && (no_way || mesh_.nav->isValidPolyRef(a.targetRef));
    for (int k = 0; k < a.nneis; ++k)
        good = good && a.neis[k].idx >= 0 && static_cast<size_t>(a.neis[k].idx) < bodies_.size();
    good = good && body.border < def_.piece_ticks && std::fabs(body.pull_s) < max_clock_s;
    for (const double x : body.beside) good = good && std::fabs(x) < 1e12;
    good = good && (body.goal_ref == 0 || mesh_.nav->isValidPolyRef(body.goal_ref));
    for (const float *vector : {a.npos, a.vel, a.targetPos, body.goal.data(), body.end.data(), a.corridor.getTarget()})
        for (int k = 0; k < 3; ++k) good = good && std::fabs(vector[k]) < 1e6f;
    for (const float x : body.aim) good = good && std::fabs(x) < 1e9f;
    double before_s = -max_clock_s;
    for (const clq_track_point &point : body.points) {
        good = good && point.time_s > before_s && point.time_s <= time_s();
        for (const double x : point.position) good = good && std::fabs(x) < 1e12;
        before_s = point.time_s;
    }
    good = good && (!body.locomotion || (!body.points.empty() && body.points.front().time_s <= body.piece_end_s &&
                                         body.piece_end_s <= time_s()));
    if (!good) bad_save("a walker has a number that no walker has");
}

void Walkers::save(stage::SaveWriter &out, const std::vector<const clq_locomotion *> &locomotions) const
{
    const std::lock_guard<std::mutex> lock(mesh_.lock);
    auto &self = const_cast<Walkers &>(*this);  // one list of fields for both directions, which changes nothing here
    out.count(mesh_.doors.size(), 1);
    for (Door &door : mesh_.doors) out.number(door.open);
    out.count(bodies_.size(), 4);
    for (Body &body : self.bodies_) out.number(body.generation);
    self.walk_totals(out);
    for (uint32_t i = 0; i < bodies_.size(); ++i)
        if (bodies_[i].used()) self.walk_body(out, i, locomotions);
}

Walkers::Doors Walkers::restore(stage::SaveReader &in, const std::vector<const clq_locomotion *> &locomotions)
{
    const std::lock_guard<std::mutex> lock(mesh_.lock);
    Doors open(in.count(0, 1));
    if (open.size() != mesh_.doors.size()) bad_save("their ground has other doors");
    for (uint8_t &one : open) in.number(one);
    if (in.count(0, 4) != bodies_.size()) bad_save("they are of another number of walkers");
    for (uint32_t i = 0; i < bodies_.size(); ++i) {
        crowd_->removeAgent(static_cast<int>(i));
        bodies_[i] = Body();
    }
    // Agents get the first free number: all up to the last, then those that are not used are removed.
    dtCrowdAgentParams params{};
    params.radius = 0.1f, params.height = 1.9f;
    const float nowhere[3] = {mesh_.min[0], mesh_.min[1], mesh_.min[2]};
    for (Body &body : bodies_) in.number(body.generation);
    for (uint32_t i = 0; i < bodies_.size(); ++i) crowd_->addAgent(nowhere, &params);
    uint32_t used = 0;
    for (uint32_t i = 0; i < bodies_.size(); ++i) {
        if (bodies_[i].used()) ++used;
        else crowd_->removeAgent(static_cast<int>(i));
    }
    walk_totals(in);
    if (count_ != used) bad_save("their number of walkers is wrong");
    for (uint32_t i = 0; i < bodies_.size(); ++i)
        if (bodies_[i].used()) walk_body(in, i, locomotions);
    pieces_.clear();
    all_published_ = true;
    return open;
}

void Walkers::set_doors(const Doors &open) noexcept
{
    const std::lock_guard<std::mutex> lock(mesh_.lock);
    const bool knows_doors = mesh_version_ != 0;
    for (uint32_t i = 0; i < open.size(); ++i) set_door(mesh_, i, open[i] != 0);
    mesh_version_ = knows_doors ? mesh_.version : 0;
}

bool Walkers::knows(clq_walker id) const noexcept
{
    return id.index1 > 0 && id.index1 <= bodies_.size() && bodies_[id.index1 - 1].used() &&
           bodies_[id.index1 - 1].generation == id.generation;
}

}  // namespace claque::walk
