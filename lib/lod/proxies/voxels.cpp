#include "lib/lod/proxies/voxels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace claque::lod
{

Voxels::Voxels(const std::vector<Triangle> &triangles, uint32_t cells)
{
    glm::dvec3 min(std::numeric_limits<double>::infinity()), max = -min;
    for (const Triangle &t : triangles)
        for (const glm::dvec3 corner : t) min = glm::min(min, corner), max = glm::max(max, corner);
    const glm::dvec3 box = max - min;
    const double longest = std::max({box.x, box.y, box.z});
    cell_ = longest > 0 ? longest / cells : 1;
    size_ = glm::uvec3(glm::floor(box / cell_)) + 3u;
    // The triangles' box is centred in the grid.
    origin_ = 0.5 * (min + max) - 0.5 * cell_ * glm::dvec3(size_);
    cells_.assign(size_t(size_.x) * size_.y * size_.z, 0);
    for (const Triangle &t : triangles) add(t);
}

// Fills the cells of points at most half a cell apart.
void Voxels::add(const Triangle &t)
{
    const double longest =
        std::max({glm::length(t[1] - t[0]), glm::length(t[2] - t[1]), glm::length(t[0] - t[2])}) / cell_;
    const uint32_t steps = 1 + static_cast<uint32_t>(2 * longest);
    for (uint32_t i = 0; i <= steps; ++i)
        for (uint32_t j = 0; i + j <= steps; ++j) {
            const double a = double(i) / steps, b = double(j) / steps;
            const glm::dvec3 p = (1 - a - b) * t[0] + a * t[1] + b * t[2];
            const glm::uvec3 at(glm::clamp((p - origin_) / cell_, glm::dvec3(0), glm::dvec3(size_ - 1u)));
            cells_[index(at.x, at.y, at.z)] = 1;
        }
}

void Voxels::fill()
{
    std::vector<uint8_t> met(cells_.size(), 0);  // in how many directions a triangle lies
    const std::array<size_t, 3> stride = {1, size_.x, size_t(size_.x) * size_.y};
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const uint32_t length = size_[axis];
        const size_t step = stride[static_cast<size_t>(axis)];
        for (uint32_t i = 0; i < size_[u]; ++i)
            for (uint32_t j = 0; j < size_[v]; ++j) {
                const size_t row = i * stride[static_cast<size_t>(u)] + j * stride[static_cast<size_t>(v)];
                uint8_t up = 0, down = 0;
                for (uint32_t k = 0; k < length; ++k) {
                    met[row + k * step] = static_cast<uint8_t>(met[row + k * step] + up);
                    up |= cells_[row + k * step];
                    const size_t back = row + (length - 1 - k) * step;
                    met[back] = static_cast<uint8_t>(met[back] + down);
                    down |= cells_[back];
                }
            }
    }
    for (size_t i = 0; i < cells_.size(); ++i)
        if (met[i] >= 5) cells_[i] = 1;
}

}  // namespace claque::lod
