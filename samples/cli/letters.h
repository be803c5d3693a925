// Capital letters for pictures, five by seven dots each; small letters are written as capitals.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cli
{

struct Ink {
    uint8_t r, g, b;
};

// Three bytes a pixel, top row first.
class Board
{
public:
    Board(int width, int height, Ink ground);

    int width() const { return width_; }
    int height() const { return height_; }
    const std::vector<uint8_t> &rgb() const { return rgb_; }

    // Both clip to the board.
    void dot(int x, int y, Ink ink);
    void fill(int x, int y, int width, int height, Ink ink);
    void paste(int x, int y, int width, int height, const std::vector<uint8_t> &rgb);
    // Letters of `scale` pixels a dot; (x, y) is the upper left corner. Bytes other than ASCII letters, digits, space
    // or one of -_.#() are drawn as a box.
    void write(int x, int y, int scale, const std::string &text, Ink ink);

private:
    int width_, height_;
    std::vector<uint8_t> rgb_;
};

constexpr int letter_width = 6, letter_height = 7;  // in dots, with the space to the next

}  // namespace cli
