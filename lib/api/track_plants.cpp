// Where the feet of a track stand.
#include <algorithm>
#include <cmath>

#include "lib/api/boundary.h"
#include "lib/api/track_handle.h"

using namespace claque;

extern "C" {

clq_status clq_track_get_plants(const clq_track *track, uint32_t foot, double from_s, double to_s, clq_track_plant *out,
                                size_t capacity, size_t *out_count)
{
    return api::boundary("clq_track_get_plants", [&] {
        api::require(track && out_count && (out || capacity == 0), "track, out or out_count is NULL");
        if (foot > 1) base::fail(CLQ_ARGUMENT, "foot is %u: 0 is the left one, 1 the right one", foot);
        if (!std::isfinite(from_s) || !std::isfinite(to_s)) base::fail(CLQ_ARGUMENT, "from_s or to_s is not finite");
        size_t count = 0;
        const auto each = [&](const auto &take) {
            for (const track::Plant &plant : track->plants[foot]) {
                const double begin_s = track->start_s + std::max(0.0, double(plant.begin_s));
                const double end_s = track->start_s + std::min(track->length_s, double(plant.end_s));
                if (begin_s <= to_s && end_s >= from_s && begin_s < end_s) take(begin_s, end_s, plant);
            }
        };
        each([&](double, double, const track::Plant &) { ++count; });
        if (out && count > capacity) base::fail(CLQ_LIMIT, "%zu plants: there is room for %zu", count, capacity);
        size_t at = 0;
        if (out)
            each([&](double begin_s, double end_s, const track::Plant &plant) {
                const double height = std::isfinite(plant.y)
                                          ? (track->origin_m.y + double(plant.y)) / track->metres_per_unit
                                          : track::position_at(*track, begin_s).y;
                out[at++] = {begin_s,
                             end_s,
                             {(track->origin_m.x + double(plant.x)) / track->metres_per_unit, height,
                              (track->origin_m.z + double(plant.z)) / track->metres_per_unit}};
            });
        *out_count = count;
    });
}

}  // extern "C"
