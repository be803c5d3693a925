#include "samples/labels/rle.h"

namespace labels
{

std::vector<uint32_t> runs_of(const std::vector<uint8_t> &inside, int width, int height)
{
    std::vector<uint32_t> runs = {0};
    uint8_t now = 0;
    for (int x = 0; x < width; ++x)
        for (int y = 0; y < height; ++y) {
            const uint8_t here =
                inside[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)] != 0 ? 1 : 0;
            if (here != now) runs.push_back(0), now = here;
            ++runs.back();
        }
    return runs;
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
