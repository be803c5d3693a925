#include "samples/cli/letters.h"

namespace cli
{
namespace
{

struct Glyph {
    char letter;
    const char *rows;  // seven rows of five dots
};

constexpr Glyph glyphs[] = {
    {'A', " ### #   ##   #######   ##   ##   #"}, {'B', "#### #   ##   ##### #   ##   ##### "},
    {'C', " ### #   ##    #    #    #   # ### "}, {'D', "#### #   ##   ##   ##   ##   ##### "},
    {'E', "######    #    #### #    #    #####"}, {'F', "######    #    #### #    #    #    "},
    {'G', " ### #   ##    # ####   ##   # ### "}, {'H', "#   ##   ##   #######   ##   ##   #"},
    {'I', " ###   #    #    #    #    #   ### "}, {'J', "  ###   #    #    #    # #  #  ##  "},
    {'K', "#   ##  # # #  ##   # #  #  # #   #"}, {'L', "#    #    #    #    #    #    #####"},
    {'M', "#   ### ### # ## # ##   ##   ##   #"}, {'N', "#   ###  ## # ##  ###   ##   ##   #"},
    {'O', " ### #   ##   ##   ##   ##   # ### "}, {'P', "#### #   ##   ##### #    #    #    "},
    {'Q', " ### #   ##   ##   ## # ##  #  ## #"}, {'R', "#### #   ##   ##### # #  #  # #   #"},
    {'S', " #####    #     ###     #    ##### "}, {'T', "#####  #    #    #    #    #    #  "},
    {'U', "#   ##   ##   ##   ##   ##   # ### "}, {'V', "#   ##   ##   ##   ##   # # #   #  "},
    {'W', "#   ##   ##   ## # ## # ### ###   #"}, {'X', "#   ##   # # #   #   # # #   ##   #"},
    {'Y', "#   ##   # # #   #    #    #    #  "}, {'Z', "#####    #   #   #   #   #    #####"},
    {'0', " ### #   ##  ### # ###  ##   # ### "}, {'1', "  #   ##    #    #    #    #   ### "},
    {'2', " ### #   #    #   #   #   #   #####"}, {'3', " ### #   #    #  ##     ##   # ### "},
    {'4', "   #   ##  # # #  # #####   #    # "}, {'5', "######    ####     #    ##   # ### "},
    {'6', " ### #    #    #### #   ##   # ### "}, {'7', "#####    #   #   #   #    #    #   "},
    {'8', " ### #   ##   # ### #   ##   # ### "}, {'9', " ### #   ##   # ####    #    # ### "},
    {' ', "                                   "}, {'-', "               #####               "},
    {'_', "                              #####"}, {'.', "                          ##   ##  "},
    {'#', " # #  # # ##### # # ##### # #  # # "}, {'(', "   #   #   #    #    #     #     # "},
    {')', " #     #     #    #    #   #   #   "},
};
constexpr char box[] = "######   ##   ##   ##   ##   ######";

const char *rows_of(char letter)
{
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
    for (const Glyph &glyph : glyphs)
        if (glyph.letter == letter) return glyph.rows;
    return box;
}

}  // namespace

Board::Board(int width, int height, Ink ground)
    : width_(width), height_(height), rgb_(3 * static_cast<size_t>(width) * static_cast<size_t>(height))
{
    fill(0, 0, width, height, ground);
}

void Board::dot(int x, int y, Ink ink)
{
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    const size_t at = 3 * (static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x));
    rgb_[at] = ink.r;
    rgb_[at + 1] = ink.g;
    rgb_[at + 2] = ink.b;
}

void Board::fill(int x, int y, int width, int height, Ink ink)
{
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) dot(x + column, y + row, ink);
}

void Board::paste(int x, int y, int width, int height, const std::vector<uint8_t> &rgb)
{
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const size_t at = 3 * (static_cast<size_t>(row) * static_cast<size_t>(width) + static_cast<size_t>(column));
            dot(x + column, y + row, {rgb[at], rgb[at + 1], rgb[at + 2]});
        }
}

void Board::write(int x, int y, int scale, const std::string &text, Ink ink)
{
    for (const char letter : text) {
        const char *rows = rows_of(letter);
        for (int i = 0; i < 35; ++i)
            if (rows[i] == '#') fill(x + i % 5 * scale, y + i / 5 * scale, scale, scale, ink);
        x += letter_width * scale;
    }
}

}  // namespace cli
