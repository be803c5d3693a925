// S1 4, S0 5: one eyeDistance an individual, to the nearest eye that sees it, gives its level, its rate and its tick.
#include "lib/base/hash.h"
#include "lib/frame/steps.h"
#include "lib/pose/clock.h"

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

void Update::look_at(uint32_t candidate)
{
    const uint32_t row = frame.candidates_[candidate];
    const crowd::Actor &actor = crowd.actor(row);
    Row &out = frame.rows_[row];
    const bool was_seen = out.seen.visible && out.generation == actor.generation && out.update + 1 == frame.update_;
    if (out.generation != actor.generation) out.seen = Seen();  // of whoever had the row before
    out.generation = actor.generation;
    out.update = frame.update_;
    float nearest = -1;
    for (uint32_t v = 0; v < views.count; ++v) {
        const float distance = frame.view_distances_[size_t(v) * frame.candidates_.size() + candidate];
        if (distance >= 0 && (nearest < 0 || distance < nearest)) nearest = distance;
    }
    out.seen.visible = nearest >= 0;
    out.steady = out.seen.visible && was_seen;
    if (!out.seen.visible) return;

    out.distance = nearest;
    out.level = level_at(crowd.template_of(row), nearest * frame.settings_.metres_per_unit);
    const uint32_t rung = animcache::rung_of(frame.settings_.period, nearest);
    const uint64_t id = uint64_t(actor.generation) << 32 | (row + 1);
    out.seen.period_s = static_cast<float>(animcache::period_s(rung));
    out.seen.shown_s = animcache::tick_s(rung, time_s, base::hash(crowd.seed(), id, base::Purpose::cache_phase));
    // A clip that has begun shows nothing of before its beginning, which would be the end of a round it never played.
    const double begun_s = crowd.play_of(row).start_s;
    if (begun_s <= time_s && out.seen.shown_s < begun_s) out.seen.shown_s = begun_s;
}

void Update::choose_levels_and_periods()
{
    const uint32_t count = static_cast<uint32_t>(frame.candidates_.size());
    for_slices(count, [this](uint32_t i) { look_at(i); });
    frame.visible_.clear();
    std::pmr::vector<animcache::Request> &requests = frame.caches_.begin();
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t row = frame.candidates_[i];
        const Row &found = frame.rows_[row];
        if (!found.seen.visible) continue;
        frame.visible_.push_back(i);
        const crowd::Play &play = crowd.play_of(row);
        animcache::Request request;
        request.tmpl = &crowd.template_of(row);
        request.row = row;
        request.level = found.level;
        request.clip = play.clip;
        request.pose.version = crowd.actor(row).play_version;
        if (play.clip != model::none)
            request.pose.clip_time_s = pose::clip_time({play.start_s, play.speed, play.phase_s},
                                                       request.tmpl->rig.clips[play.clip], found.seen.shown_s);
        requests.push_back(request);
    }
}

}  // namespace claque::frame
