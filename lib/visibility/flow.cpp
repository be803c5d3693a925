#include "lib/visibility/flow.h"

#include <limits>

#include "lib/visibility/corners.h"

namespace claque::visibility
{
namespace
{

// The triangle of the pixel before, which the next one often shows too.
struct Moving {
    uint64_t number = ~uint64_t(0);
    Found found;
    Corners corners;
    glm::dvec3 then[3] = {};  // in the other camera's eye space
};

void begin(const Picture &picture, base::Span<const Moved> moved, uint64_t number, Moving &shown)
{
    shown.number = number;
    shown.found = picture.numbers.find(number);
    shown.corners = corners_of(picture.list, picture.list.items[shown.found.item], picture.vertices[shown.found.item],
                               shown.found.corners);
    const Moved &other = moved[shown.found.item];
    if (!other.there) return;
    for (int k = 0; k < 3; ++k) {
        const float *p = other.positions + 3 * size_t(shown.found.corners[k]);
        shown.then[k] = other.origin + other.axes * glm::dvec3(p[0], p[1], p[2]);
    }
}

}  // namespace

void write_flow(const Picture &picture, base::Span<const Moved> moved, const float *projection, const base::Jobs &jobs,
                float *out)
{
    const glm::dvec2 half = picture.half();
    picture.for_rows(jobs, [&](size_t first, size_t last) {
        Moving shown;
        for (size_t pixel = first; pixel < last; ++pixel) {
            uint64_t number = 0;
            out[2 * pixel] = out[2 * pixel + 1] = std::numeric_limits<float>::quiet_NaN();
            if (!picture.number_at(pixel, number)) continue;
            if (number != shown.number) begin(picture, moved, number, shown);
            if (!moved[shown.found.item].there) continue;
            const glm::dvec2 centre = picture.centre(pixel);
            const glm::dvec3 weights = shown.corners.weights_at(centre, half);
            const glm::dvec3 then = weights.x * shown.then[0] + weights.y * shown.then[1] + weights.z * shown.then[2];
            const glm::dvec3 clip = clip_of(projection, then);
            if (!(clip.z > 0)) continue;
            const glm::dvec2 moved_px = (glm::dvec2(clip.x / clip.z, clip.y / clip.z) - centre) * half;
            out[2 * pixel] = static_cast<float>(moved_px.x), out[2 * pixel + 1] = static_cast<float>(moved_px.y);
        }
    });
}

}  // namespace claque::visibility
