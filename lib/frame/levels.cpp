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
uint32_t Update::level_of(const Row &row, uint32_t crowd_row, float effective_distance_m) const
{
    const model::Template &tmpl = crowd.template_of(crowd_row);
    const uint32_t level = level_at(tmpl, effective_distance_m);
    const float hysteresis = frame.settings_.lod_hysteresis;
    if (hysteresis == 0 || !row.visible_before || level >= row.visibility.level) return level;
    return std::min(row.visibility.level, level_at(tmpl, effective_distance_m / (1 - hysteresis)));
}

void Update::evaluate_candidate(uint32_t index)
{
    Candidate &candidate = frame.candidates_[index];
    const uint32_t row = candidate.row;
    const crowd::Actor &actor = crowd.actor(row);
    Row &out = frame.rows_[row];
    const bool was_visible =
        out.visibility.visible && out.generation == actor.generation && out.update + 1 == frame.update_;
    if (out.generation != actor.generation)
        out.visibility = ActorVisibility(), out.shown_at = 0;  // of whoever had the row before
    out.generation = actor.generation;
    out.update = frame.update_;
    out.candidate = index;

    float nearest = -1, effective = -1;
    const double wish = (1 - double(crowd.extent_of(row).priority)) * double(frame.settings_.lod_scale);
    bool any = false;
    for (uint32_t v = 0; v < views.count; ++v)
        any = any || view_visibility(v, index).inside != math::Containment::outside;
    for (uint32_t v = 0; v < views.count; ++v) {
        const ViewVisibility &visibility = view_visibility(v, index);
        // Traditional mode evaluates who is seen by nobody as well, and who is seen as actor mode does.
        if (visibility.inside == math::Containment::outside && (any || !traditional())) continue;
        const CameraState &eye = frame.eyes_[v];
        const float here = static_cast<float>((visibility.distance * eye.distance_scale + eye.min_distance) * wish);
        if (nearest < 0 || visibility.distance < nearest) nearest = visibility.distance;
        if (effective < 0 || here < effective) effective = here;
    }
    out.visibility.visible = nearest >= 0;
    out.visible_before = out.visibility.visible && was_visible;
    if (!out.visibility.visible) return;

    candidate.effective_distance_m = effective * frame.settings_.caches.metres_per_unit;
    out.visibility.distance = nearest;
    out.visibility.level = level_of(out, row, candidate.effective_distance_m);
    candidate.levels = behave::mechanism_levels(crowd, row, candidate.effective_distance_m,
                                                crowd.template_of(row).levels[out.visibility.level]);
    const animcache::Settings &caches = frame.settings_.caches;
    const bool each_frame =
        behave::has_memory(crowd, row) || caches.key_poses.mode_at(nearest) == animcache::KeyPoseMode::skinned;
    const uint32_t rate_step = each_frame ? 0 : animcache::rate_step_of(caches.period, nearest);
    const uint64_t id = uint64_t(actor.generation) << 32 | (row + 1);
    const double before_s = out.visibility.shown_s;
    out.visibility.period_s = static_cast<float>(animcache::period_s(rate_step));
    out.visibility.shown_s =
        animcache::tick_s(rate_step, time_s, base::hash(crowd.seed(), id, base::Purpose::cache_phase));
    // A clip that has begun shows nothing of before its beginning, which would be the end of a round it never played.
    const double begun_s = crowd.play_of(row).start_s;
    if (begun_s <= time_s && out.visibility.shown_s < begun_s) out.visibility.shown_s = begun_s;
    const bool bound = frame.settings_.clock == Clock::live && out.shown_at > frame.live_since_;
    if (bound && out.visibility.shown_s < before_s) out.visibility.shown_s = before_s;
    out.shown_at = frame.update_;
}

void Update::request(uint32_t index)
{
    const Candidate &candidate = frame.candidates_[index];
    const uint32_t row = candidate.row;
    const Row &found = frame.rows_[row];
    const bool behaves = crowd.behaviours().has_mechanisms(row);
    animcache::Request request;
    request.tmpl = &crowd.template_of(row);
    request.row = row;
    request.level = found.visibility.level;
    request.shown_s = found.visibility.shown_s;
    request.period_s = found.visibility.period_s;
    request.distance = found.visibility.distance;
    if (frame.settings_.rigid_mode == animcache::RigidMode::matrices && request.tmpl->has_rigid_parts_only())
        request.rigid_mode = animcache::RigidMode::matrices;
    request.pose.version = crowd.actor(row).play_version;
    request.pose.skeletal_level = request.tmpl->levels[found.visibility.level].skeletal_level;
    if (behaves) {
        request.pose.tick_s = found.visibility.shown_s;
        request.pose.behaviour_levels = candidate.levels;
    }
    choose_clips(request, candidate.levels);
    if (!behaves && request.layers.count == 0) share_key_poses(request);
    frame.requested_.push_back(index);
    frame.caches_.pending().push_back(request);
}

// S3 3, 4. Who is moved by anything else than one clip has no key-poses, but its own cache.
void Update::share_key_poses(animcache::Request &request) const
{
    const animcache::KeyPoses &key_poses = frame.caches_.key_poses();
    const animcache::KeyPoseMode mode = key_poses.mode_at(request.distance);
    if (!animcache::shows_key_poses(mode) || request.pose.clip == model::none) return;
    request.key_pose = key_poses.select(crowd.actor(request.row).tmpl, request.level, mode, request.pose.clip,
                                        request.pose.clip_time_s);
    request.rigid_mode = animcache::RigidMode::vertices;
    request.pose.interpolated = mode == animcache::KeyPoseMode::interpolated;
    if (!request.pose.interpolated) request.pose.clip_time_s = request.key_pose.time_s[0];
}

void Update::choose_levels_and_periods()
{
    const uint32_t count = static_cast<uint32_t>(frame.candidates_.size());
    if (frame.has_last_time_ && time_s < frame.last_time_s_) frame.live_since_ = frame.update_ - 1;
    for_slices(count, [this](uint32_t i) { evaluate_candidate(i); });
    frame.requested_.clear();
    frame.layers_.clear();
    frame.caches_.begin();
    frame.stats_.crossing = frame.stats_.passed_sklsroot = 0;
    for (uint32_t i = 0; i < count; ++i)
        if (frame.rows_[frame.candidates_[i].row].visibility.visible) request(i);
    frame.stats_.passed_sklsroot = static_cast<uint32_t>(frame.requested_.size());
}

}  // namespace claque::frame
