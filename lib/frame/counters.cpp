#include <algorithm>

#include "lib/frame/steps.h"

namespace claque::frame
{

// Band 0 is nearer than d_near, the last beyond d_far, the others share the way between equally.
void Frame::reset_bands()
{
    const float near = settings_.caches.period.d_near, far = settings_.caches.period.d_far;
    const auto edge = [&](uint32_t k) { return near + (far - near) * float(k) / float(band_count - 2); };
    for (uint32_t i = 0; i < band_count; ++i) {
        stats_.bands[i] = Band();
        stats_.bands[i].distance_min = i == 0 ? 0 : edge(i - 1);
        stats_.bands[i].distance_max = edge(std::min(i, band_count - 2));
    }
}

uint32_t Update::band_of(float distance) const
{
    uint32_t band = 0;
    while (band + 1 < band_count && distance >= frame.stats_.bands[band + 1].distance_min) ++band;
    return band;
}

void Update::count()
{
    const animcache::Counters &counters = frame.caches_.counters();
    Stats &stats = frame.stats_;
    stats.visible = static_cast<uint32_t>(frame.visible_.size());
    stats.matrices_built = counters.matrices_built;
    stats.due = counters.due;
    stats.animated = counters.animated;
    stats.skinned = counters.skinned;
    stats.palette_served = counters.palette_served;
    stats.vertices_served = counters.vertices_served;
    stats.on_demand = counters.on_demand;
    stats.deferred = counters.deferred;
    stats.overdue = counters.overdue;
    stats.over_budget = counters.over_budget;
    stats.evicted = counters.evicted;
    stats.cache_bytes = counters.bytes;
    stats.cache_pool_bytes = counters.pool_bytes;
    stats.key_poses = frame.caches_.key_poses().counters();

    // Rates are what happens in time that passes: a jump, or coming into view, is not a rate.
    const double gone = frame.has_last_time_ ? time_s - frame.last_time_s_ : 0;
    const bool passes = gone > 0 && gone < 1;
    for (const animcache::Request &request : frame.caches_.requests()) {
        if (!request.drawn) continue;
        const Row &row = frame.rows_[request.row];
        Band &band = stats.bands[band_of(row.visibility.distance)];
        ++band.actor_frames;
        if (!passes || !row.visible_before) continue;
        band.seconds += gone;
        band.animated += frame.caches_.was_animated(request.row);
    }
    frame.last_time_s_ = time_s;
    frame.has_last_time_ = true;
}

}  // namespace claque::frame
