// The statistics of distance bands: how often actors at each range of distances were animated.
#include <algorithm>

#include "lib/frame/frame.h"
#include "lib/frame/steps.h"

namespace claque::frame
{

// Band 0 is nearer than d_near and the last band is beyond d_far; the others divide the distance between them equally.
void Frame::reset_bands()
{
    Stats &stats = work_.stats;
    const float near = work_.settings.caches.period.d_near, far = work_.settings.caches.period.d_far;
    const auto edge = [&](uint32_t k) { return near + (far - near) * float(k) / float(band_count - 2); };
    for (uint32_t i = 0; i < band_count; ++i) {
        stats.bands[i] = Band();
        stats.bands[i].distance_min = i == 0 ? 0 : edge(i - 1);
        stats.bands[i].distance_max = edge(std::min(i, band_count - 2));
    }
}

base::Status CountBands::check() const
{
    if (bands.empty()) return base::Status::bad(CLQ_ARGUMENT, "no distance band");
    for (const animcache::Request &request : caches.requests())
        if (request.drawn && request.slot >= rows.count)
            return base::Status::bad(CLQ_ARGUMENT, "slot %u of %u is drawn", request.slot, rows.count);
    return base::Status::good();
}

void CountBands::run() const
{
    // A rate needs elapsed time: the update of a jump and that in which an actor comes into view are not counted.
    const bool passes = elapsed_s > 0 && elapsed_s < 1;
    for (const animcache::Request &request : caches.requests()) {
        if (!request.drawn) continue;
        const Row &row = rows[request.slot];
        uint32_t k = 0;
        while (k + 1 < bands.count && row.visibility.distance >= bands[k + 1].distance_min) ++k;
        Band &band = bands[k];
        ++band.actor_frames;
        if (!passes || !row.visible_before) continue;
        band.seconds += elapsed_s;
        band.animated += caches.was_animated(request.slot);
    }
}

}  // namespace claque::frame
