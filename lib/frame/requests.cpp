// Chooses what each visible candidate shows in this update: one clip, layers in memory of this update, or key-poses.
#include <algorithm>

#include "lib/behave/active_clips.h"
#include "lib/frame/steps.h"
#include "lib/pose/clock.h"

namespace claque::frame
{

// What an actor with layers, mechanisms or a track shows is a function of version, tick and levels. If the cache keeps
// that pose, its clips need not be chosen again.
bool MakeRequests::keep_pose(animcache::Request &request) const
{
    const animcache::PoseKey *kept = caches.kept_pose(request.slot);
    if (!kept || request.shown_s == 0) return false;  // 0 is also the tick of poses that are no function of ticks
    if (kept->tick_s != request.shown_s || kept->version != request.pose.version ||
        kept->behaviour_levels != request.pose.behaviour_levels || kept->skeletal_level != request.pose.skeletal_level)
        return false;
    request.pose = *kept;
    request.blend_radius = caches.kept_radius(request.slot);
    return true;
}

void MakeRequests::choose_clip(animcache::Request &request) const
{
    const crowd::Play &play = given.crowd.play_of(request.row);
    request.pose.clip = play.clip;
    if (play.clip == model::none) return;
    request.pose.clip_time_s =
        pose::clip_time({play.start_s, play.speed, play.phase_s}, request.tmpl->rig.clips[play.clip], request.shown_s);
}

void MakeRequests::choose_layers(animcache::Request &request, uint64_t levels) const
{
    const crowd::Crowd &crowd = given.crowd;
    const uint32_t row = request.row;
    const crowd::Follow *follow = crowd.follows().of(row);
    behave::ActiveClips shown;
    behave::active_clips_at(crowd, row, request.shown_s, levels, shown);
    request.pose.clip = shown.clip;
    request.pose.clip_time_s = shown.clip_time_s;
    if (shown.count == 0 && shown.foot_count == 0) return;
    // The layers are a function of the tick.
    request.pose.tick_s = request.shown_s;
    request.pose.layers = shown.count;
    request.foot_count = shown.foot_count;
    std::copy(shown.feet, shown.feet + shown.foot_count, request.feet);
    request.upper = shown.upper;
    const crowd::LayerState *layer_state = crowd.layers().of(row);
    request.blend_radius = crowd::blended_reach_of(*request.tmpl, layer_state ? layer_state->max_additive_weight() : 0);
    if (follow) request.blend_radius += crowd::room_of(*follow);
    const size_t first = layers.size();
    layers.insert(layers.end(), shown.layers, shown.layers + shown.count);
    request.layers = {layers.data() + first, shown.count};
}

// S3 3, 4. Only actors that play a single clip can show key-poses; the others use caches of their own.
void MakeRequests::share_key_poses(animcache::Request &request) const
{
    const animcache::KeyPoses &key_poses = caches.key_poses();
    const animcache::KeyPoseMode mode = key_poses.mode_at(request.distance);
    if (!animcache::shows_key_poses(mode) || request.pose.clip == model::none) return;
    request.key_pose = key_poses.select(given.crowd.actor(request.row).tmpl, request.level, mode, request.pose.clip,
                                        request.pose.clip_time_s);
    request.rigid_mode = animcache::RigidMode::vertices;
    request.pose.interpolated = mode == animcache::KeyPoseMode::interpolated;
    if (!request.pose.interpolated) request.pose.clip_time_s = request.key_pose.time_s[0];
}

// Makes the request of an individual that shows one clip, or a pose that is kept. False: its layers must still be
// chosen.
bool MakeRequests::make(const Candidate &candidate, animcache::Request &request) const
{
    const crowd::Crowd &crowd = given.crowd;
    const uint32_t row = candidate.row;
    const Row &found = rows[candidate.slot];
    const bool behaves = crowd.behaviours().has_mechanisms(row), follows = crowd.follows().of(row);
    request = animcache::Request();
    if (!found.visibility.visible) return true;
    request.tmpl = &crowd.template_of(row);
    request.row = row;
    request.slot = candidate.slot;
    request.level = found.visibility.level;
    request.shown_s = found.visibility.shown_s;
    request.period_s = found.visibility.period_s;
    request.distance = found.visibility.distance;
    if (given.settings.rigid_mode == animcache::RigidMode::matrices && request.tmpl->has_rigid_parts_only())
        request.rigid_mode = animcache::RigidMode::matrices;
    request.pose.version = crowd.actor(row).play_version;
    request.pose.skeletal_level = request.tmpl->levels[found.visibility.level].skeletal_level;
    if (behaves) {
        request.pose.tick_s = found.visibility.shown_s;
        request.pose.behaviour_levels = candidate.levels;
    }
    if (follows) request.rigid_mode = animcache::RigidMode::vertices;
    if (keep_pose(request)) return true;
    if (behaves || follows || crowd.layers().of(row)) return false;
    choose_clip(request);
    share_key_poses(request);
    return true;
}

base::Status MakeRequests::check() const
{
    if (requests.capacity() < candidates.count || blends.count < candidates.count || !has_slots(candidates, rows))
        return base::Status::bad(CLQ_ARGUMENT, "no room for a request of every candidate, or not a result of it");
    return base::Status::good();
}

void MakeRequests::run() const
{
    layers.clear();
    requests.resize(candidates.count);
    uint32_t visible[Given::part_count];
    given.for_parts(candidates.count, [&](uint32_t part, uint32_t first, uint32_t last) {
        uint32_t count = 0;
        for (uint32_t i = first; i < last; ++i) {
            blends[i] = !make(candidates[i], requests[i]);
            count += requests[i].tmpl != nullptr;
        }
        visible[part] = count;
    });
    stats.passed_sklsroot = 0;
    for (const uint32_t count : visible) stats.passed_sklsroot += count;
    // One after the other: layers have one memory, in the order of the candidates.
    for (uint32_t i = 0; i < candidates.count; ++i) {
        if (!blends[i]) continue;
        animcache::Request &request = requests[i];
        choose_layers(request, candidates[i].levels);
        if (given.crowd.behaviours().has_mechanisms(request.row)) continue;
        if (request.layers.count == 0 && request.foot_count == 0) share_key_poses(request);
    }
}

}  // namespace claque::frame
