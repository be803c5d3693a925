// S1 4, S0 5: one eyeDistance an individual, to the nearest eye that sees it, gives its rate and its tick; its effective
// distance the levels of its geometry, its skeleton and its behaviour.
#include <algorithm>

#include "lib/base/hash.h"
#include "lib/frame/steps.h"

namespace claque::frame
{

namespace
{

// The last level whose distance is reached; the finest before the first is.
uint32_t level_at(const model::Template &tmpl, float distance_m)
{
    uint32_t level = 0;
    while (level + 1 < tmpl.levels.size() && tmpl.levels[level + 1].switch_distance_m <= distance_m) ++level;
    return level;
}

}  // namespace

// With hysteresis, who was coarser a moment ago becomes finer only once a share of the way back is behind it.
uint32_t Update::level_of(const Row &row, uint32_t crowd_row, float effective_m) const
{
    const model::Template &tmpl = crowd.template_of(crowd_row);
    const uint32_t level = level_at(tmpl, effective_m);
    const float hysteresis = frame.settings_.lod_hysteresis;
    if (hysteresis == 0 || !row.steady || level >= row.seen.level) return level;
    return std::min(row.seen.level, level_at(tmpl, effective_m / (1 - hysteresis)));
}

void Update::look_at(uint32_t index)
{
    Candidate &candidate = frame.candidates_[index];
    const uint32_t row = candidate.row;
    const crowd::Actor &actor = crowd.actor(row);
    Row &out = frame.rows_[row];
    const bool was_seen = out.seen.visible && out.generation == actor.generation && out.update + 1 == frame.update_;
    if (out.generation != actor.generation) out.seen = Seen(), out.shown_at = 0;  // of whoever had the row before
    out.generation = actor.generation;
    out.update = frame.update_;
    out.candidate = index;

    float nearest = -1, effective = -1;
    const double wish = (1 - double(crowd.extent_of(row).priority)) * double(frame.settings_.lod_scale);
    bool any = false;
    for (uint32_t v = 0; v < views.count; ++v) any = any || sight(v, index).inside != math::Inside::no;
    for (uint32_t v = 0; v < views.count; ++v) {
        const Sight &seen = sight(v, index);
        // Traditional mode evaluates who is seen by nobody as well, and who is seen as actor mode does.
        if (seen.inside == math::Inside::no && (any || !traditional())) continue;
        const EyeOf &eye = frame.eyes_[v];
        const float here = static_cast<float>((seen.distance * eye.detail + eye.least) * wish);
        if (nearest < 0 || seen.distance < nearest) nearest = seen.distance;
        if (effective < 0 || here < effective) effective = here;
    }
    out.seen.visible = nearest >= 0;
    out.steady = out.seen.visible && was_seen;
    if (!out.seen.visible) return;

    candidate.effective_m = effective * frame.settings_.caches.metres_per_unit;
    out.seen.distance = nearest;
    out.seen.level = level_of(out, row, candidate.effective_m);
    candidate.levels =
        behave::levels_of(crowd, row, candidate.effective_m, crowd.template_of(row).levels[out.seen.level]);
    const animcache::Settings &caches = frame.settings_.caches;
    const bool each_frame =
        behave::has_memory(crowd, row) || caches.key_poses.method_at(nearest) == animcache::Method::skinned;
    const uint32_t rung = each_frame ? 0 : animcache::rung_of(caches.period, nearest);
    const uint64_t id = uint64_t(actor.generation) << 32 | (row + 1);
    const double before_s = out.seen.shown_s;
    out.seen.period_s = static_cast<float>(animcache::period_s(rung));
    out.seen.shown_s = animcache::tick_s(rung, time_s, base::hash(crowd.seed(), id, base::Purpose::cache_phase));
    // A clip that has begun shows nothing of before its beginning, which would be the end of a round it never played.
    const double begun_s = crowd.play_of(row).start_s;
    if (begun_s <= time_s && out.seen.shown_s < begun_s) out.seen.shown_s = begun_s;
    const bool bound = frame.settings_.clock == Clock::live && out.shown_at > frame.live_since_;
    if (bound && out.seen.shown_s < before_s) out.seen.shown_s = before_s;
    out.shown_at = frame.update_;
}

void Update::request(uint32_t index)
{
    const Candidate &candidate = frame.candidates_[index];
    const uint32_t row = candidate.row;
    const Row &found = frame.rows_[row];
    const bool behaves = crowd.behaviours().has_uses(row);
    animcache::Request request;
    request.tmpl = &crowd.template_of(row);
    request.row = row;
    request.level = found.seen.level;
    request.shown_s = found.seen.shown_s;
    request.period_s = found.seen.period_s;
    request.distance = found.seen.distance;
    if (frame.settings_.placement == animcache::Placement::matrices && request.tmpl->has_rigid_parts_only())
        request.placement = animcache::Placement::matrices;
    request.pose.version = crowd.actor(row).play_version;
    request.pose.skeletal = request.tmpl->levels[found.seen.level].skeletal;
    if (behaves) {
        request.pose.tick_s = found.seen.shown_s;
        request.pose.behaviour_levels = candidate.levels;
    }
    choose_clips(request, candidate.levels);
    if (!behaves && request.layers.count == 0) share_key_poses(request);
    frame.asked_.push_back(index);
    frame.caches_.pending().push_back(request);
}

// S3 3, 4. Who is moved by anything else than one clip has no key-poses, but its own cache.
void Update::share_key_poses(animcache::Request &request) const
{
    const animcache::KeyPoses &key_poses = frame.caches_.key_poses();
    const animcache::Method method = key_poses.method_at(request.distance);
    if (!animcache::shows_key_poses(method) || request.pose.clip == model::none) return;
    request.shared = key_poses.use(crowd.actor(request.row).tmpl, request.level, method, request.pose.clip,
                                   request.pose.clip_time_s);
    request.placement = animcache::Placement::vertices;
    request.pose.interpolated = method == animcache::Method::interpolated;
    if (!request.pose.interpolated) request.pose.clip_time_s = request.shared.time_s[0];
}

void Update::choose_levels_and_periods()
{
    const uint32_t count = static_cast<uint32_t>(frame.candidates_.size());
    if (frame.has_last_time_ && time_s < frame.last_time_s_) frame.live_since_ = frame.update_ - 1;
    for_slices(count, [this](uint32_t i) { look_at(i); });
    frame.asked_.clear();
    frame.layers_.clear();
    frame.caches_.begin();
    frame.stats_.crossing = frame.stats_.passed_sklsroot = 0;
    for (uint32_t i = 0; i < count; ++i)
        if (frame.rows_[frame.candidates_[i].row].seen.visible) request(i);
    frame.stats_.passed_sklsroot = static_cast<uint32_t>(frame.asked_.size());
}

}  // namespace claque::frame
