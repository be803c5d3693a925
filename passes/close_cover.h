// The texels of an image that triangles show, and for all others the nearest of these.
#pragma once

#include <glm/vec2.hpp>

#include "passes/uv_row.h"

namespace claque::passes
{

using model::Array;

class CloseCover
{
public:
    CloseCover(uint32_t width, uint32_t height, model::Wrap wrap_s, model::Wrap wrap_t,
               std::pmr::memory_resource *memory)
        : width_(width), height_(height), wrap_s_(wrap_s), wrap_t_(wrap_t), shown_(size_t(width) * height, 0, memory)
    {
    }

    // Every texel that GL_NEAREST can take anywhere in the triangle; all texels for one that wraps many times.
    void add(const glm::vec2 (&uv)[3]);
    bool shows(size_t texel) const { return shown_[texel] != 0; }
    void leave_out(size_t texel) { shown_[texel] = 0; }

    // For each texel itself if it is shown, else the shown one that is fewest steps away; each itself if none is shown.
    Array<uint32_t> sources() const;

private:
    void add_row(int64_t row, double low, double high);

    uint32_t width_, height_;
    model::Wrap wrap_s_, wrap_t_;
    Array<uint8_t> shown_;
};

}  // namespace claque::passes
