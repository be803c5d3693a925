#include "lib/asset/zone_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/error.h"

namespace claque::asset
{

namespace
{

// Rows of the image that all triangles together may cover: so many, and for each triangle and texel.
constexpr uint64_t most_rows = 1u << 24, rows_per_item = 64;

using UvCorners = std::array<float, 6>;

// The texels whose centres lie in triangles, and those that contain a corner. A row of a triangle is one span, marked
// at its ends only, so a triangle costs its height and not its area.
class Coverage
{
public:
    explicit Coverage(const model::Image &image)
        : w_(image.width), h_(image.height), ends_((size_t(image.width) + 1) * image.height)
    {
    }

    void add(const UvCorners &uv)
    {
        double x[3], y[3];
        for (size_t k = 0; k < 3; ++k) x[k] = double(uv[2 * k]) * w_, y[k] = double(uv[2 * k + 1]) * h_;
        for (size_t k = 0; k < 3; ++k) mark(x[k], y[k]);
        const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        const auto [left, right] = std::minmax({x[0], x[1], x[2]});
        const auto [top, bottom] = std::minmax({y[0], y[1], y[2]});
        if (area == 0 || right - left > 4 * w_ || bottom - top > 4 * h_) return;
        for (double py = std::floor(top) + 0.5; py < bottom; ++py) {
            ++rows_;
            const auto holds = [&](double px) {
                const double a = ((x[1] - px) * (y[2] - py) - (x[2] - px) * (y[1] - py)) / area;
                const double b = ((x[2] - px) * (y[0] - py) - (x[0] - px) * (y[2] - py)) / area;
                return a >= 0 && b >= 0 && a + b <= 1;
            };
            add_row(x, y, py, std::floor(left) + 0.5, right, holds);
        }
    }

    uint64_t rows() const { return rows_; }

    std::vector<uint8_t> texels() const
    {
        std::vector<uint8_t> out;
        out.reserve(size_t(w_) * size_t(h_));
        for (size_t row = 0; row < size_t(h_); ++row)
            for (int64_t x = 0, open = 0; x < int64_t(w_); ++x) {
                open += ends_[row * (size_t(w_) + 1) + size_t(x)];
                out.push_back(open > 0);
            }
        return out;
    }

private:
    // The centres of a row between the edges. Only those near an edge are tested one by one.
    template <class Holds>
    void add_row(const double (&x)[3], const double (&y)[3], double py, double first, double right, const Holds &holds)
    {
        double low = right, high = first;
        for (size_t k = 0; k < 3; ++k) {
            const size_t n = (k + 1) % 3;
            if ((y[k] < py && y[n] < py) || (y[k] > py && y[n] > py)) continue;
            if (y[k] == y[n]) {
                low = std::min({low, x[k], x[n]}), high = std::max({high, x[k], x[n]});
                continue;
            }
            const double at = x[k] + (x[n] - x[k]) * ((py - y[k]) / (y[n] - y[k]));
            low = std::min(low, at), high = std::max(high, at);
        }
        double px = std::max(first, first + std::floor(low - first) - 2);
        const double last = std::min(right, high + 3), inner = high - 3;
        for (; px < last && px < low + 3; ++px)
            if (holds(px)) mark(px, py);
        if (inner - px >= 1) {
            const double count = std::floor(inner - px);
            span(px, py, count);
            px += count;
        }
        for (; px < last; ++px)
            if (holds(px)) mark(px, py);
    }

    void mark(double px, double py) { span(px, py, 1); }

    // `count` texels to the right of a point, round the edge of the image.
    void span(double px, double py, double count)
    {
        px -= w_ * std::floor(px / w_), py -= h_ * std::floor(py / h_);
        int32_t *row = ends_.data() + std::min(size_t(py), size_t(h_) - 1) * (size_t(w_) + 1);
        size_t from = std::min(size_t(px), size_t(w_) - 1);
        if (count >= w_) from = 0, count = w_;
        const size_t end = from + size_t(count), width = size_t(w_);
        ++row[from], --row[std::min(end, width)];
        if (end > width) ++row[0], --row[end - width];
    }

    const double w_, h_;
    std::vector<int32_t> ends_;  // per row and column: spans that begin here, less those that end before it
    uint64_t rows_ = 0;
};

// Every triangle that shows the image, each only once: triangles on one another show the same texels.
std::vector<UvCorners> triangles_showing(const model::Model &model, uint32_t image)
{
    std::vector<UvCorners> out;
    for (const model::Part &part : model.parts) {
        if (part.hidden || part.material == model::none || part.uvs.empty()) continue;
        bool shows = model.materials[part.material].image == image;
        for (const model::TextureSet &set : model.texture_sets) shows = shows || set.images[part.material] == image;
        if (!shows) continue;
        for (const auto &t : model::triangles_of(part))
            out.push_back({part.uvs[t[0]].x, part.uvs[t[0]].y, part.uvs[t[1]].x, part.uvs[t[1]].y, part.uvs[t[2]].x,
                           part.uvs[t[2]].y});
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

}  // namespace

std::vector<uint8_t> covered_texels(const model::Model &model, uint32_t image)
{
    const model::Image &of = model.images[image];
    const std::vector<UvCorners> triangles = triangles_showing(model, image);
    const uint64_t maximum = most_rows + rows_per_item * (triangles.size() + uint64_t(of.width) * of.height);
    Coverage coverage(of);
    for (const UvCorners &triangle : triangles) {
        coverage.add(triangle);
        if (coverage.rows() > maximum)
            base::fail(
                CLQ_LIMIT, "%zu triangles of '%s' cover more than %llu rows of image %u '%s', which has %u x %u texels",
                triangles.size(), model.name.c_str(), base::big(maximum), image, of.name.c_str(), of.width, of.height);
    }
    return coverage.texels();
}

}  // namespace claque::asset
