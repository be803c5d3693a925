#include "passes/close_cover.h"

#include <cmath>
#include <numeric>

namespace claque::passes
{

void CloseCover::add(const glm::vec2 (&uv)[3])
{
    double x[3], y[3];
    bool known = true;
    for (int k = 0; k < 3; ++k) {
        x[k] = double(uv[k].x) * width_, y[k] = double(uv[k].y) * height_;
        known = known && std::fabs(x[k]) < max_texels_across && std::fabs(y[k]) < max_texels_across;
    }
    const auto [minimum, maximum] = std::minmax({y[0], y[1], y[2]});
    constexpr int turns = 4;
    if (!known || maximum - minimum > turns * double(height_))
        return std::fill(shown_.begin(), shown_.end(), uint8_t(1));
    for (int64_t row = static_cast<int64_t>(std::floor(minimum - snapping));
         row <= static_cast<int64_t>(std::floor(maximum + snapping)); ++row) {
        double low = 1e30, high = -1e30;
        widen(x, y, double(row) - snapping, double(row + 1) + snapping, low, high);
        if (low <= high) add_row(row, low, high);
    }
}

void CloseCover::add_row(int64_t row, double low, double high)
{
    uint8_t *texels = shown_.data() + size_t(wrapped(row, height_, wrap_t_)) * width_;
    const int64_t first = static_cast<int64_t>(std::floor(low - snapping));
    const int64_t last = static_cast<int64_t>(std::floor(high + snapping));
    const bool all = wrap_s_ == model::Wrap::repeat && last - first >= width_;
    const int64_t count = all ? width_ : last - first + 1;
    for (int64_t i = 0; i < count; ++i) texels[wrapped(first + i, width_, wrap_s_)] = 1;
}

// A search in width from all shown texels at once, in a fixed order.
Array<uint32_t> CloseCover::sources() const
{
    const uint32_t count = static_cast<uint32_t>(shown_.size());
    Array<uint32_t> found(count, model::none, shown_.get_allocator());
    Array<uint32_t> queue(shown_.get_allocator());
    queue.reserve(count);
    for (uint32_t i = 0; i < count; ++i)
        if (shown_[i]) found[i] = i, queue.push_back(i);
    if (queue.empty()) std::iota(found.begin(), found.end(), 0u);
    for (size_t at = 0; at < queue.size(); ++at) {
        const int64_t x = queue[at] % width_, y = queue[at] / width_;
        const int64_t beside[4][2] = {{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}};
        for (const auto &[s, t] : beside) {
            const size_t to = size_t(wrapped(t, height_, wrap_t_)) * width_ + size_t(wrapped(s, width_, wrap_s_));
            if (found[to] != model::none) continue;
            found[to] = found[queue[at]];
            queue.push_back(static_cast<uint32_t>(to));
        }
    }
    return found;
}

}  // namespace claque::passes
