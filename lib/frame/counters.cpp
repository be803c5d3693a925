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
    if (bands.empty() || bands.count > band_count)
        return base::Status::bad(CLQ_ARGUMENT, "%u distance bands: 1 to %u are counted", bands.count, band_count);
    for (const animcache::Request &request : caches.requests())
        if (request.drawn && request.slot >= rows.count)
            return base::Status::bad(CLQ_ARGUMENT, "slot %u of %u is drawn", request.slot, rows.count);
    return base::Status::good();
}

namespace
{

struct BandCounts {
    uint32_t frames[band_count] = {}, timed[band_count] = {}, animated[band_count] = {};
};

}  // namespace

void CountBands::run() const
{
    // A rate needs elapsed time: the update of a jump and that in which an actor comes into view are not counted.
    const bool passes = elapsed_s > 0 && elapsed_s < 1;
    const base::Span<const animcache::Request> requests = caches.requests();
    BandCounts parts[Given::part_count];
    given.for_parts(requests.count, [&](uint32_t part, uint32_t first, uint32_t last) {
        BandCounts counts;
        for (uint32_t i = first; i < last; ++i) {
            if (!requests[i].drawn) continue;
            const Row &row = rows[requests[i].slot];
            uint32_t k = 0;
            while (k + 1 < bands.count && row.visibility.distance >= bands[k + 1].distance_min) ++k;
            const bool timed = passes && row.visible_before;
            ++counts.frames[k];
            counts.timed[k] += timed;
            counts.animated[k] += timed && caches.was_animated(requests[i].slot);
        }
        parts[part] = counts;
    });
    for (const BandCounts &counts : parts)
        for (uint32_t k = 0; k < bands.count; ++k) {
            bands[k].actor_frames += counts.frames[k];
            bands[k].seconds += elapsed_s * counts.timed[k];
            bands[k].animated += counts.animated[k];
        }
}

}  // namespace claque::frame
