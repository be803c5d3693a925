// Pictures for comparison in tests.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

struct Picture {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb;
};

// Empty if the file is missing or not a picture.
Picture read_picture(const std::string &path);

struct Difference {
    uint64_t pixels = 0;  // that differ by more than the allowed steps in a channel
    int most = 0;         // largest difference of one channel
};

// Pictures of different sizes differ in every pixel.
Difference compare(const Picture &a, const Picture &b, int allowed_steps = 0);

// The differing pixels as a PGM: white differs, black does not.
void write_difference(const std::string &path, const Picture &a, const Picture &b);
