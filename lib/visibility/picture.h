// A visibility picture that was read back, and the vertices of the individuals in it.
#pragma once

#include <claque/visibility.h>

#include "lib/frame/frame.h"
#include "lib/visibility/found.h"

namespace claque::visibility
{

struct Picture {
    const clq_pixels &pixels;
    const draw::DrawList &list;
    const Numbers &numbers;
    base::Span<const draw::Vertices> vertices;  // by item; those that no pixel shows may be empty

    size_t size() const { return size_t(pixels.width_px) * pixels.height_px; }
    // False: the pixel shows no individual.
    bool number_at(size_t pixel, uint64_t &out) const
    {
        if (pixels.numbers[pixel] < pixels.first_number) return false;
        out = pixels.numbers[pixel] - pixels.first_number;
        return true;
    }
    // The centre of a pixel, -1 to 1 each way.
    glm::dvec2 centre(size_t pixel) const
    {
        const double x = static_cast<double>(pixel % pixels.width_px), y = static_cast<double>(pixel / pixels.width_px);
        return {2 * (x + 0.5) / pixels.width_px - 1, 2 * (y + 0.5) / pixels.height_px - 1};
    }
    glm::dvec2 half() const { return {0.5 * pixels.width_px, 0.5 * pixels.height_px}; }
    // Rows are independent of each other.
    template <class Body>
    void for_rows(const base::Jobs &jobs, const Body &body) const
    {
        jobs.for_each(pixels.height_px, [&](uint32_t y) {
            const size_t first = size_t(y) * pixels.width_px;
            body(first, first + pixels.width_px);
        });
    }
};

}  // namespace claque::visibility
