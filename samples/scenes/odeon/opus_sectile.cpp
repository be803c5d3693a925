#include "samples/scenes/odeon/opus_sectile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "samples/scenes/odeon/noise.h"
#include "samples/scenes/random.h"

namespace scenes
{
namespace
{

struct Marble {
    double r, g, b;
    double veins;  // how strongly they differ from the ground
};
// Imperial porphyry, giallo antico, green serpentine, pavonazzetto, grey granite: worn and dusty, so that the floor
// does not distract from the people above it.
constexpr Marble porphyry = {0.56, 0.36, 0.33, 0.14}, floor_giallo = {0.84, 0.70, 0.48, 0.16};
constexpr Marble floor_serpentine = {0.44, 0.51, 0.43, 0.22}, white = {0.87, 0.83, 0.75, 0.20};
constexpr Marble floor_granite = {0.66, 0.63, 0.59, 0.12};

// One cut piece: its marble, its number, and its distance to the edge as a fraction of the floor's radius.
struct Piece {
    Marble marble;
    uint64_t id;
    double to_edge;
};

constexpr int side_px = 1024;
constexpr double joint_fade = 0.0022;  // width of a joint's shading, as a fraction of the floor's radius
constexpr int spokes = 72;             // of the rim's ring of wedges
constexpr double rim = 0.965, wedges = 0.875, line = 0.85;

// Rings round the floor: a white rim, wedges of alternating colours, a line of porphyry.
Piece ring(double x, double y, double radius)
{
    const double edge = std::min({std::abs(radius - rim), std::abs(radius - wedges), std::abs(radius - line)});
    // The angle over a full turn without a library's arc functions: exact at the diagonals, nearly even between.
    const double slant = x / (std::abs(x) + std::abs(y));
    const double turn = (y >= 0 ? 1 - slant : 3 + slant) / 4;
    const double along = turn * spokes, nearest = std::floor(along + 0.5);
    const uint64_t spoke = static_cast<uint64_t>(along);
    if (radius >= rim) return {white, 4000 + spoke / 3, edge};
    if (radius < wedges) return {porphyry, 4200 + spoke / 3, edge};
    // A wedge narrows inwards to a point: giallo between serpentine.
    const double inwards = (rim - radius) / (rim - wedges);
    const double off = std::abs(along - std::floor(along) - 0.5) * 2;  // 0 in its middle, 1 where two meet
    const double side = (1 - inwards) - off;
    const double to_side = std::abs(side) * radius * 2.2 / spokes;
    if (side > 0) return {floor_giallo, 4400 + spoke, std::min(edge, to_side)};
    return {floor_serpentine, 4600 + static_cast<uint64_t>(nearest) % spokes, std::min(edge, to_side)};
}

// A panel in coordinates of its own, -1 to 1: a circle or a square in a square, framed by white bands.
Piece panel(double x, double y, int column, int row, double unit)
{
    const uint64_t id = static_cast<uint64_t>((row + 64) * 128 + column + 64) * 4;
    const double square = std::max(std::abs(x), std::abs(y));
    if (square > 0.84) return {white, id, std::min(1.0 - std::min(std::abs(x), std::abs(y)), square - 0.84) * unit};
    const bool round = ((column + row) & 1) == 0;
    const bool warm = ((column - row) / 2 & 1) == 0;
    if (round) {
        const double out = std::sqrt(x * x + y * y);
        if (out < 0.56) return {warm ? porphyry : floor_serpentine, id + 1, (0.56 - out) * unit};
        if (out < 0.70) return {white, id + 2, std::min(out - 0.56, 0.70 - out) * unit};
        return {warm ? floor_giallo : floor_granite, id + 3, std::min(out - 0.70, 0.84 - square) * unit};
    }
    const double diamond = std::abs(x) + std::abs(y);
    if (square < 0.36) return {floor_granite, id + 1, (0.36 - square) * unit};
    if (diamond < 0.84) return {floor_giallo, id + 2, std::min((0.84 - diamond) * 0.7, square - 0.36) * unit};
    return {warm ? porphyry : floor_serpentine, id + 3, std::min((diamond - 0.84) * 0.7, 0.84 - square) * unit};
}

Piece piece_at(double x, double y, int panels)
{
    const double radius = std::sqrt(x * x + y * y);
    if (radius >= line) return ring(x, y, radius);
    const double unit = 1.0 / panels;  // half a panel
    const double across = x / unit / 2 + 0.5, up = y / unit / 2 + 0.5;
    const double column = std::floor(across), row = std::floor(up);
    Piece piece =
        panel((across - column) * 2 - 1, (up - row) * 2 - 1, static_cast<int>(column), static_cast<int>(row), unit);
    piece.to_edge = std::min(piece.to_edge, line - radius);
    return piece;
}

// The brightness of a stone at a texel: clouds, veins where a noise crosses zero, wear; each piece has a tone of its
// own.
double stone(const Piece &piece, uint64_t seed, double x, double y, uint64_t texel)
{
    const double tone = random_between(seed, piece.id, Purpose::tone, 0.93, 1.06);
    const double slide = 50 * random_unit(seed, piece.id, Purpose::slab);
    const double vein = gradient_noise(seed + 11, x * 9 + slide, y * 7 - slide);
    const double drawn = std::max(0.0, 1 - std::abs(vein) * 9);
    const double worn = gradient_noise(seed + 13, x * 3, y * 3);
    const double grain = random_unit(seed, texel, Purpose::grain) - 0.5;
    return tone * (1 + 0.05 * grain + 0.10 * vein + 0.09 * worn - piece.marble.veins * 0.55 * drawn);
}

// The mean over the texel of the pieces' colours and joints; noise is sampled once, because it is smooth.
std::array<uint8_t, 4> texel(uint64_t seed, int panels, int column, int row)
{
    constexpr int samples = 2, all = samples * samples;
    double rgb[3] = {0, 0, 0}, light = 1;
    for (int k = 0; k < all; ++k) {
        const double x = (column + (k % samples + 0.5) / samples) / side_px * 2 - 1;
        const double y = (row + (k / samples + 0.5) / samples) / side_px * 2 - 1;
        const Piece piece = piece_at(x, y, panels);
        if (k == 0)
            light = stone(piece, seed, x, y, static_cast<uint64_t>(row) * side_px + static_cast<uint64_t>(column));
        const double joint = 0.74 + 0.26 * std::clamp(piece.to_edge / joint_fade, 0.0, 1.0);
        const double ground[3] = {piece.marble.r, piece.marble.g, piece.marble.b};
        for (int channel = 0; channel < 3; ++channel) rgb[channel] += ground[channel] * joint / all;
    }
    const auto byte = [](double v) { return static_cast<uint8_t>(std::clamp(v, 0.0, 1.0) * 255.0 + 0.5); };
    return {byte(rgb[0] * light), byte(rgb[1] * light), byte(rgb[2] * light), 255};
}

}  // namespace

Image opus_sectile(uint64_t seed, int panels)
{
    Image image;
    image.side_px = side_px;
    image.rgba.reserve(static_cast<size_t>(4) * side_px * side_px);
    for (int row = 0; row < side_px; ++row)
        for (int column = 0; column < side_px; ++column) {
            const std::array<uint8_t, 4> rgba = texel(seed, panels, column, row);
            image.rgba.insert(image.rgba.end(), rgba.begin(), rgba.end());
        }
    return image;
}

}  // namespace scenes
