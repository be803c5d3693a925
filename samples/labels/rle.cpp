#include "samples/labels/rle.h"

namespace labels
{
namespace
{

class Runs
{
public:
    void add(uint8_t value, uint32_t pixels)
    {
        if (pixels == 0) return;
        if (value != now_) runs_.push_back(0), now_ = value;
        runs_.back() += pixels;
    }
    std::vector<uint32_t> take() { return std::move(runs_); }

private:
    std::vector<uint32_t> runs_ = {0};
    uint8_t now_ = 0;
};

}  // namespace

std::vector<uint32_t> runs_of(const std::vector<uint8_t> &inside, int width, int height)
{
    Runs runs;
    for (int x = 0; x < width; ++x)
        for (int y = 0; y < height; ++y)
            runs.add(inside[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)] != 0 ? 1 : 0,
                     1);
    return runs.take();
}

std::vector<uint32_t> runs_of(const std::vector<uint32_t> &values, uint32_t value, int width, int height,
                              const Box &box)
{
    const int x0 = static_cast<int>(box.x0), y0 = static_cast<int>(box.y0), x1 = static_cast<int>(box.x1),
              y1 = static_cast<int>(box.y1);
    Runs runs;
    runs.add(0, static_cast<uint32_t>(x0) * static_cast<uint32_t>(height));
    for (int x = x0; x < x1; ++x) {
        runs.add(0, static_cast<uint32_t>(y0));
        for (int y = y0; y < y1; ++y) {
            const size_t at = static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
            runs.add(values[at] == value ? 1 : 0, 1);
        }
        runs.add(0, static_cast<uint32_t>(height - y1));
    }
    runs.add(0, static_cast<uint32_t>(width - x1) * static_cast<uint32_t>(height));
    return runs.take();
}

std::string letters_of(const std::vector<uint32_t> &runs)
{
    std::string out;
    for (size_t i = 0; i < runs.size(); ++i) {
        int64_t left = runs[i];
        if (i > 2) left -= runs[i - 2];
        for (bool more = true; more;) {
            int64_t bits = left & 31;
            left >>= 5;  // keeps the sign
            more = (bits & 16) != 0 ? left != -1 : left != 0;
            if (more) bits |= 32;
            out += static_cast<char>(bits + 48);
        }
    }
    return out;
}

}  // namespace labels
