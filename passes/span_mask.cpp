#include "passes/span_mask.h"

namespace claque::passes
{
namespace
{

// An edge directed upwards, so that it is the same for both its triangles.
struct Edge {
    glm::vec2 low, high;
    float slope = 0;

    Edge(glm::vec2 a, glm::vec2 b) : low(a), high(b)
    {
        if (high.y < low.y) std::swap(low, high);
        if (high.y > low.y) slope = (high.x - low.x) / (high.y - low.y);
    }
    void cross(float y, float &first, float &last) const
    {
        if (!(low.y <= y && y < high.y)) return;
        const float x = low.x + (y - low.y) * slope;
        first = std::min(first, x);
        last = std::max(last, x);
    }
};

// The first pixel whose centre is not before `at`; 0 for NaN, which a vertex near the largest number may become.
int32_t pixel_of(float at, int32_t end)
{
    const float x = std::max(-1.0f, std::min(at - 0.5f, static_cast<float>(end)));
    const int32_t cut = static_cast<int32_t>(x);
    return std::max(0, cut + (static_cast<float>(cut) < x));
}

// Bits [first, last) of a word.
uint64_t bits(int32_t first, int32_t last)
{
    const uint64_t all = ~uint64_t(0);
    return (all << first) & (all >> (64 - last));
}

int32_t lowest(uint64_t word) { return static_cast<int32_t>(__builtin_ctzll(word)); }

}  // namespace

void SpanMask::reserve(int32_t width, int32_t height)
{
    const size_t words = size_t((width + 63) / 64) * size_t(height);
    if (done_.size() < words) done_.resize(words);
    if (own_.size() < words) own_.resize(words);  // zero, and zero again after each take()
}

void SpanMask::begin(int32_t width, int32_t height)
{
    width_ = width, height_ = height, words_ = (width + 63) / 64;
    std::fill(done_.begin(), done_.begin() + std::ptrdiff_t(words_) * height, uint64_t(0));
    first_row_ = height_, end_row_ = 0;
}

void SpanMask::add(glm::vec2 a, glm::vec2 b, glm::vec2 c)
{
    const int32_t first = pixel_of(std::min({a.y, b.y, c.y}), height_);
    const int32_t end = pixel_of(std::max({a.y, b.y, c.y}), height_);
    const Edge edges[3] = {{a, b}, {b, c}, {c, a}};
    for (int32_t row = first; row < end; ++row) {
        const float y = static_cast<float>(row) + 0.5f;
        float from = static_cast<float>(width_), to = 0;
        for (const Edge &edge : edges) edge.cross(y, from, to);
        const int32_t x0 = pixel_of(from, width_), x1 = pixel_of(to, width_);
        if (x0 < x1) fill(row, x0, x1);
    }
}

void SpanMask::fill(int32_t row, int32_t x0, int32_t x1)
{
    const int32_t word0 = x0 / 64, word1 = (x1 - 1) / 64;
    if (first_row_ >= end_row_) first_word_ = word0, end_word_ = word1 + 1;
    first_word_ = std::min(first_word_, word0), end_word_ = std::max(end_word_, word1 + 1);
    first_row_ = std::min(first_row_, row), end_row_ = std::max(end_row_, row + 1);
    uint64_t *words = own_.data() + size_t(row) * size_t(words_);
    for (int32_t w = word0; w <= word1; ++w)
        words[w] |= bits(w == word0 ? x0 - 64 * w : 0, w == word1 ? x1 - 64 * w : 64);
}

// Finds the new pixels of a row and marks them as old.
void SpanMask::find_runs(int32_t y)
{
    run_count_ = 0;
    uint64_t *own = own_.data() + size_t(y) * size_t(words_), *done = done_.data() + size_t(y) * size_t(words_);
    int32_t end = -1;  // of the last run
    for (int32_t w = first_word_; w < end_word_; ++w) {
        uint64_t fresh = own[w] & ~done[w];
        done[w] |= own[w];
        own[w] = 0;
        while (fresh) {
            const int32_t from = lowest(fresh);
            const uint64_t after = ~(fresh >> from);
            const int32_t length = after ? lowest(after) : 64;
            fresh = from + length >= 64 ? 0 : fresh & ~bits(from, from + length);
            const int32_t x0 = 64 * w + from, x1 = x0 + length;
            if (run_count_ > 0 && end == x0) runs_[run_count_ - 1].x1 = x1;
            else if (run_count_ < max_runs) runs_[run_count_++] = {x0, x1, y, y + 1};
            end = run_count_ < max_runs ? x1 : -1;
        }
    }
}

}  // namespace claque::passes
