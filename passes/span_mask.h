// The pixels that are already in shadow, one bit each. They keep shadows from darkening a pixel twice if the host lends
// no stencil bit. A depth test cannot: fragments of triangles in one plane differ in their last bits.
#pragma once

#include <algorithm>

#include <glm/vec2.hpp>

#include "lib/model/model.h"

namespace claque::passes
{

// Pixels [x0, x1) of rows [y0, y1).
struct PixelBox {
    int32_t x0 = 0, x1 = 0, y0 = 0, y1 = 0;
};

class SpanMask
{
public:
    explicit SpanMask(std::pmr::memory_resource *memory) : done_(memory), own_(memory) {}

    // Grows only; throws std::bad_alloc.
    void reserve(int32_t width, int32_t height);
    // Clears the mask. The size must have been reserved.
    void begin(int32_t width, int32_t height);

    // Adds the pixels whose centre is inside. Corners are finite and in pixels, row 0 at y = 0.
    void add(glm::vec2 a, glm::vec2 b, glm::vec2 c);

    // Calls emit(PixelBox) for boxes that together cover the pixels added since the last call and by no call before.
    template <class Emit>
    void take(Emit emit)
    {
        open_count_ = 0;
        for (int32_t y = first_row_; y < end_row_; ++y) {
            find_runs(y);
            close_and_extend(y, emit);
        }
        for (uint32_t i = 0; i < open_count_; ++i) emit(open_[i]);
        first_row_ = height_, end_row_ = 0;
    }

private:
    static constexpr uint32_t max_runs = 256;  // per row; further runs are ignored

    void fill(int32_t row, int32_t x0, int32_t x1);
    void find_runs(int32_t y);

    // Boxes grow by runs that equal those of the row above.
    template <class Emit>
    void close_and_extend(int32_t y, Emit emit)
    {
        uint32_t old = 0;
        for (uint32_t i = 0; i < run_count_; ++i) {
            while (old < open_count_ && open_[old].x0 < runs_[i].x0) emit(open_[old++]);
            const bool same = old < open_count_ && open_[old].x0 == runs_[i].x0 && open_[old].x1 == runs_[i].x1;
            runs_[i].y0 = same ? open_[old++].y0 : y;
            runs_[i].y1 = y + 1;
        }
        while (old < open_count_) emit(open_[old++]);
        std::swap(open_, runs_);
        open_count_ = run_count_;
    }

    int32_t width_ = 0, height_ = 0, words_ = 0;  // words per row
    int32_t first_row_ = 0, end_row_ = 0;         // of the added pixels
    int32_t first_word_ = 0, end_word_ = 0;
    model::Array<uint64_t> done_, own_;
    PixelBox boxes_[2][max_runs];
    PixelBox *open_ = boxes_[0], *runs_ = boxes_[1];
    uint32_t open_count_ = 0, run_count_ = 0;
};

}  // namespace claque::passes
