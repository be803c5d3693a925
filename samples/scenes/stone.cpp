#include "samples/scenes/stone.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/random.h"

namespace scenes
{
namespace
{

double smooth_noise(double t) { return t * t * (3 - 2 * t); }

// Smooth noise in [0, 1] that repeats every `cells_x` by `cells_y` lattice cells over the unit square.
class Noise
{
public:
    Noise(uint64_t seed, int cells_x, int cells_y)
        : wide_(cells_x), high_(cells_y), values_(static_cast<size_t>(cells_x) * static_cast<size_t>(cells_y))
    {
        for (size_t i = 0; i < values_.size(); ++i) values_[i] = random_unit(seed, i, Purpose::grain);
    }
    double operator()(double u, double v) const
    {
        const double x = u * wide_, y = v * high_;
        const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
        const double fx = smooth_noise(x - x0), fy = smooth_noise(y - y0);
        const double low = at(x0, y0) * (1 - fx) + at(x0 + 1, y0) * fx;
        const double high = at(x0, y0 + 1) * (1 - fx) + at(x0 + 1, y0 + 1) * fx;
        return low * (1 - fy) + high * fy;
    }

private:
    double at(int x, int y) const { return values_[static_cast<size_t>((y % high_) * wide_ + x % wide_)]; }
    int wide_, high_;
    std::vector<double> values_;
};

// One course: the ends of its slabs, as fractions of the repeat, and the start of the first.
struct Course {
    double shift;
    std::vector<double> ends;  // ascending, the last is 1
};

Course course(uint64_t seed, uint64_t row)
{
    Course made;
    made.shift = random_unit(seed, row, Purpose::row);
    double at = 0;
    for (uint64_t slab = 0; at < 1; ++slab) {
        at += random_between(seed, row * 64 + slab, Purpose::slab, 0.11, 0.22);
        if (at > 0.9) at = 1;
        made.ends.push_back(at);
    }
    return made;
}

uint8_t byte(double value) { return static_cast<uint8_t>(std::clamp(value, 0.0, 1.0) * 255.0 + 0.5); }

void put(Image &image, size_t texel, double r, double g, double b)
{
    const uint8_t rgba[4] = {byte(r), byte(g), byte(b), 255};
    std::copy(rgba, rgba + 4, image.rgba.begin() + static_cast<ptrdiff_t>(4 * texel));
}

Image blank(int side_px)
{
    Image image;
    image.side_px = side_px;
    image.rgba.resize(4 * static_cast<size_t>(side_px) * static_cast<size_t>(side_px));
    return image;
}

}  // namespace

Image flagstones(uint64_t seed)
{
    constexpr int side = 1024, rows = 8;
    Image image = blank(side);
    const Noise clouds(seed, 9, 9), bands(seed + 1, 24, 150), pits(seed + 2, 340, 512), fine(seed + 3, 512, 512);
    for (int y = 0; y < side; ++y) {
        const double v = (y + 0.5) / side;
        const int row = y * rows / side;
        const Course stones = course(seed, static_cast<uint64_t>(row));
        const double to_course = std::min(v * rows - row, row + 1 - v * rows) / rows;  // fractions of the repeat
        for (int x = 0; x < side; ++x) {
            const double u = (x + 0.5) / side;
            double along = u + stones.shift;
            along -= std::floor(along);
            const size_t slab = static_cast<size_t>(
                std::upper_bound(stones.ends.begin(), stones.ends.end() - 1, along) - stones.ends.begin());
            const double first = slab == 0 ? 0 : stones.ends[slab - 1];
            const double to_joint = std::min({to_course, along - first, stones.ends[slab] - along}) * flagstone_metres;
            const uint64_t id = static_cast<uint64_t>(row) * 64 + slab;

            double tone = 0.86 + 0.13 * (random_unit(seed, id, Purpose::tone) - 0.5) + 0.10 * (clouds(u, v) - 0.5);
            tone += 0.055 * (bands(u, v) - 0.5) + 0.045 * (fine(u, v) - 0.5);
            if (pits(u, v) > 0.86) tone -= 0.06;
            const double worn = smooth_noise(std::clamp(to_joint / 0.05, 0.0, 1.0));   // edges are a little darker
            const double open = smooth_noise(std::clamp(to_joint / 0.014, 0.0, 1.0));  // the joint itself, in metres
            tone *= (0.93 + 0.07 * worn) * (0.55 + 0.45 * open);
            const double warm = 0.035 * (random_unit(seed, id, Purpose::grain) - 0.3);
            put(image, static_cast<size_t>(y) * side + static_cast<size_t>(x), tone * (1.01 + warm), tone * 0.975,
                tone * (0.915 - warm));
        }
    }
    return image;
}

Image plaster(uint64_t seed)
{
    constexpr int side = 256;
    Image image = blank(side);
    const Noise broad(seed + 4, 5, 4), stains(seed + 5, 23, 9), fine(seed + 6, 128, 128);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double u = (x + 0.5) / side, v = (y + 0.5) / side;
            const double tone =
                0.93 + 0.07 * (broad(u, v) - 0.5) + 0.08 * (stains(u, v) - 0.5) + 0.05 * (fine(u, v) - 0.5);
            put(image, static_cast<size_t>(y) * side + static_cast<size_t>(x), tone, tone * 0.995, tone * 0.98);
        }
    return image;
}

}  // namespace scenes
