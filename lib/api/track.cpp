// clq_track, and actors that follow one.
#include <cmath>

#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"
#include "lib/api/recorder.h"
#include "lib/api/track_handle.h"
#include "lib/track/build.h"
#include "lib/track/passings.h"
#include "lib/track/track_file.h"

using namespace claque;

clq_track::~clq_track() { api::release(held); }

namespace claque::api
{

void release(clq_track *track)
{
    if (--track->holders == 0) unmake(track->context, track);
}

}  // namespace claque::api

namespace
{

// Holds a track for a crowd, unless it has it already; gives it back unless `keep` is called.
class NewTrack
{
public:
    NewTrack(clq_crowd *crowd, clq_track *track) : crowd_(crowd)
    {
        api::require(track->context == crowd->context, "the track is of another context");
        if (!crowd->tracks.insert(track).second) return;
        api::hold(track);
        held_ = track;
    }
    NewTrack(const NewTrack &) = delete;
    NewTrack &operator=(const NewTrack &) = delete;
    ~NewTrack()
    {
        if (!held_) return;
        crowd_->tracks.erase(held_);
        api::release(held_);
    }
    void keep() { held_ = nullptr; }

private:
    clq_crowd *crowd_;
    clq_track *held_ = nullptr;
};

void read_points(const clq_track_def &def, model::Array<track::Point> &points)
{
    for (uint32_t i = 0; i < def.point_count; ++i) {
        const clq_track_point &p = def.points[i];
        points.push_back({p.time_s, glm::dvec3(p.position[0], p.position[1], p.position[2]), double(p.heading_rad)});
    }
}

// The points of all definitions behind each other.
struct PointsOfAll {
    explicit PointsOfAll(clq_context *context) : points(&context->memory), spans(&context->memory) {}
    model::Array<track::Point> points;
    model::Array<base::Span<const track::Point>> spans;
    double metres_per_unit = 1;

    void read(const clq_track_def *const *defs, uint32_t count)
    {
        size_t sum = 0;
        for (uint32_t i = 0; i < count; ++i) {
            api::require(defs[i] != nullptr, "one of defs is NULL");
            const clq_track_def def = api::read_def(defs[i], clq_track_def_init, "clq_track_def_init");
            api::require_array(def.points, def.point_count, "points");
            const double metres = double(def.metres_per_unit);
            if (i > 0 && metres != metres_per_unit)
                base::fail(CLQ_ARGUMENT,
                           "metres_per_unit of track %u is %g, of those before it %g: one world is wanted", i, metres,
                           metres_per_unit);
            metres_per_unit = metres;
            sum += def.point_count;
        }
        points.reserve(sum), spans.reserve(count);
        for (uint32_t i = 0; i < count; ++i) {
            const clq_track_def def = api::read_def(defs[i], clq_track_def_init, "clq_track_def_init");
            const size_t first = points.size();
            read_points(def, points);
            spans.push_back({points.data() + first, def.point_count});
        }
    }
};

double gait_phase(double phase)
{
    const double part = phase - std::floor(phase);
    return part < 1 ? part : 0;
}

}  // namespace

extern "C" {

clq_status clq_track_create(const clq_locomotion *locomotion, const clq_track_def *def, clq_track **out)
{
    return api::boundary("clq_track_create", [&] {
        api::require(locomotion && def && out, "locomotion, def or out is NULL");
        const clq_track_def wanted = api::read_def(def, clq_track_def_init, "clq_track_def_init");
        api::require_array(wanted.points, wanted.point_count, "points");
        model::Array<track::Point> points(&locomotion->context->memory);
        points.reserve(wanted.point_count);
        read_points(wanted, points);
        api::require_array(wanted.passings, wanted.passing_count, "passings");
        model::Array<track::Passing> passings(&locomotion->context->memory);
        passings.reserve(wanted.passing_count);
        for (uint32_t i = 0; i < wanted.passing_count; ++i) {
            const double *p = wanted.passings[i].position;
            passings.push_back({wanted.passings[i].time_s, glm::dvec3(p[0], p[1], p[2])});
        }
        track::BuildSettings settings;
        settings.passings = base::Span<const track::Passing>(passings);
        settings.smooth_s = double(wanted.smooth_s);
        settings.metres_per_unit = double(wanted.metres_per_unit);
        settings.scale = double(wanted.scale);
        settings.seed = wanted.seed;
        settings.previous = wanted.previous;
        settings.end_s = wanted.end_s;
        settings.ground = wanted.ground, settings.ground_user = wanted.ground_user;
        if (wanted.previous)
            api::require(wanted.previous->context == locomotion->context, "the piece before is of another context");
        api::Making<clq_track> made(locomotion->context, locomotion);
        track::build(*locomotion, base::Span<const track::Point>(points), settings, *made);
        *out = made.release();
    });
}

clq_status clq_find_passings(clq_context *context, const clq_track_def *const *defs, uint32_t def_count,
                             clq_found_passing *out, size_t capacity, size_t *out_count)
{
    return api::boundary("clq_find_passings", [&] {
        api::require(context && (defs || def_count == 0) && out_count && (out || capacity == 0),
                     "context, defs, out or out_count is NULL");
        PointsOfAll all(context);
        all.read(defs, def_count);
        model::Array<track::FoundPassing> found(&context->memory);
        track::find_passings(base::Span<const base::Span<const track::Point>>(all.spans), all.metres_per_unit, found);
        if (out && found.size() > capacity)
            base::fail(CLQ_LIMIT, "%zu passings: there is room for %zu", found.size(), capacity);
        for (size_t i = 0; out && i < found.size(); ++i) {
            const glm::dvec3 &p = found[i].passing.position;
            out[i] = {found[i].person, {found[i].passing.time_s, {p.x, p.y, p.z}}};
        }
        *out_count = found.size();
    });
}

void clq_track_destroy(clq_track *track)
{
    if (track) api::release(track);
}

void clq_track_hold(clq_track *track)
{
    if (track) api::hold(track);
}

clq_status clq_track_get_info(const clq_track *track, clq_track_info *out)
{
    return api::boundary("clq_track_get_info", [&] {
        api::require(track && out, "track or out is NULL");
        api::require_size(*out, "clq_track_info_init");
        clq_track_info info = clq_track_info_init();
        info.sample_count = static_cast<uint32_t>(track->samples.size());
        info.start_s = track->start_s, info.end_s = track->start_s + track->length_s;
        info.rate_hz = track->rate_hz;
        info.distance_m = track->distance_m, info.standing_s = track->standing_s;
        info.mean_shift_m = track->mean_shift_m, info.max_shift_m = track->max_shift_m;
        info.plant_count = static_cast<uint32_t>(track->plants[0].size() + track->plants[1].size());
        info.bytes = track->bytes();
        info.hash = track->hash;
        info.previous_hash = track->previous_hash;
        api::write_out(out, info);
    });
}

clq_status clq_track_evaluate(const clq_track *track, double time_s, clq_track_state *out)
{
    return api::boundary("clq_track_evaluate", [&] {
        api::require(track && out, "track or out is NULL");
        if (!std::isfinite(time_s)) base::fail(CLQ_ARGUMENT, "time_s is not finite");
        const track::State state = track::state_at(*track, time_s);
        clq_track_state found{};
        found.present = track::is_present(*track, time_s);
        found.stands = state.stands;
        for (int k = 0; k < 3; ++k) found.position[k] = state.position[k];
        found.heading_rad = state.heading_rad;
        found.phase = gait_phase(state.phase);
        found.gait = state.gait;
        found.speed_m_s = static_cast<float>(track::motion_at(*track, time_s).speed * track->metres_per_unit);
        *out = found;
    });
}

clq_status clq_track_save(const clq_track *track, clq_write_function write, void *user)
{
    return api::boundary("clq_track_save", [&] {
        api::require(track && write, "track or write is NULL");
        model::Array<uint8_t> bytes(&track->context->memory);
        track::save(*track, bytes);
        if (!api::host_takes(write, user, bytes.data(), bytes.size()))
            base::fail(CLQ_IO, "the writer refused %zu bytes of a track", bytes.size());
    });
}

clq_status clq_track_load(const clq_locomotion *locomotion, const void *bytes, size_t size_bytes, clq_track **out)
{
    return api::boundary("clq_track_load", [&] {
        api::require(locomotion && bytes && out, "locomotion, bytes or out is NULL");
        api::Making<clq_track> made(locomotion->context, locomotion);
        track::load(static_cast<const uint8_t *>(bytes), size_bytes, *locomotion, *made);
        *out = made.release();
    });
}

clq_status clq_actor_follow_track(clq_crowd *crowd, clq_actor actor, clq_track *track, double start_s)
{
    return api::boundary("clq_actor_follow_track", [&] {
        api::require(crowd && track, "crowd or track is NULL");
        const api::Busy busy(crowd);
        crowd->crowd.row_of(api::id_of(actor));
        NewTrack held(crowd, track);
        crowd::follow_track(crowd->crowd, api::id_of(actor), *track, start_s);
        held.keep();
        api::changed_by(crowd, [&](api::Recorder &to) { to.follow(actor, *track, start_s); });
    });
}

clq_status clq_actor_fade_to_track(clq_crowd *crowd, clq_actor actor, double at_s, float length_s)
{
    return api::boundary("clq_actor_fade_to_track", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd::fade_to_track(crowd->crowd, api::id_of(actor), at_s, length_s, crowd::Curve::smooth);
        api::changed(crowd, record::ActorFadeToTrack{actor, at_s, length_s});
    });
}

clq_status clq_actor_leave_track(clq_crowd *crowd, clq_actor actor, double at_s)
{
    return api::boundary("clq_actor_leave_track", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd::leave_track(crowd->crowd, api::id_of(actor), at_s);
        api::changed(crowd, record::ActorLeaveTrack{actor, at_s});
    });
}

clq_status clq_crowd_add_track(clq_crowd *crowd, clq_track *track)
{
    return api::boundary("clq_crowd_add_track", [&] {
        api::require(crowd && track, "crowd or track is NULL");
        const api::Busy busy(crowd);
        NewTrack held(crowd, track);
        crowd->crowd.tables.follows.add(*track);
        held.keep();
    });
}

clq_status clq_crowd_release_tracks(clq_crowd *crowd, uint32_t *released)
{
    return api::boundary("clq_crowd_release_tracks", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        std::pmr::unordered_set<const track::Track *> used(&crowd->context->memory);
        crowd->crowd.tables.follows.forget_unused(used);
        uint32_t count = 0;
        for (auto at = crowd->tracks.begin(); at != crowd->tracks.end();) {
            if (used.count(*at)) {
                ++at;
                continue;
            }
            clq_track *unused = *at;
            at = crowd->tracks.erase(at);
            api::release(unused);
            ++count;
        }
        crowd->lender = 0;  // a record that goes on gives its tracks again
        if (released) *released = count;
    });
}

}  // extern "C"
