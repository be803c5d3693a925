// A picture file as pixels, read by libpng.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace cli_test
{

struct Picture {
    int width = 0, height = 0;  // 0: not a PNG
    std::vector<unsigned char> rgb;

    int count_of(const std::array<int, 3> &colour) const;
};
Picture picture_of(const std::string &path);

}  // namespace cli_test
