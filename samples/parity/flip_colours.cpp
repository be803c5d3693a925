#include "samples/parity/flip_colours.h"

#include <cmath>

namespace parity::flip
{
namespace
{

// sRGB's primaries and white as in the paper's supplement: whole numbers over a common denominator.
constexpr double to_xyz[3][3] = {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                 {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                 {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};

constexpr double white(int row) { return to_xyz[row][0] + to_xyz[row][1] + to_xyz[row][2]; }

// XYZ relative to the white: every grey has three equal numbers.
Colour relative_xyz(const Colour &linear)
{
    Colour out = {};
    for (int r = 0; r < 3; ++r) {
        const double sum =
            to_xyz[r][0] * double(linear[0]) + to_xyz[r][1] * double(linear[1]) + to_xyz[r][2] * double(linear[2]);
        out[static_cast<size_t>(r)] = static_cast<float>(sum / white(r));
    }
    return out;
}

// Cofactor over determinant of the matrix above.
double inverse(int r, int c)
{
    const auto m = [](int row, int column) { return to_xyz[row % 3][column % 3]; };
    const auto cofactor = [&](int row, int column) {
        return m(row + 1, column + 1) * m(row + 2, column + 2) - m(row + 1, column + 2) * m(row + 2, column + 1);
    };
    const double determinant = m(0, 0) * cofactor(0, 0) + m(0, 1) * cofactor(0, 1) + m(0, 2) * cofactor(0, 2);
    return cofactor(c, r) / determinant;
}

// From XYZ relative to the white back to RGB.
std::array<std::array<float, 3>, 3> back_matrix()
{
    std::array<std::array<float, 3>, 3> out = {};
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            out[static_cast<size_t>(r)][static_cast<size_t>(c)] = static_cast<float>(inverse(r, c) * white(c));
    return out;
}

float lab_curve(float t)
{
    constexpr float delta = 6.0f / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0f / 29;
}

std::array<float, 256> linear_table()
{
    std::array<float, 256> table = {};
    for (size_t i = 0; i < table.size(); ++i) {
        const double s = static_cast<double>(i) / 255;
        table[i] = static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
    }
    return table;
}

}  // namespace

Colour linear_of(const uint8_t *srgb)
{
    static const std::array<float, 256> table = linear_table();
    return {table[srgb[0]], table[srgb[1]], table[srgb[2]]};
}

Colour opponent_of(const Colour &linear)
{
    const Colour t = relative_xyz(linear);
    return {116 * t[1] - 16, 500 * (t[0] - t[1]), 200 * (t[1] - t[2])};
}

Colour linear_of_opponent(const Colour &o)
{
    static const auto back = back_matrix();
    const float y = (o[0] + 16) / 116, x = y + o[1] / 500, z = y - o[2] / 200;
    Colour out = {};
    for (size_t r = 0; r < 3; ++r) out[r] = back[r][0] * x + back[r][1] * y + back[r][2] * z;
    return out;
}

Colour hunt_lab_of(const Colour &linear)
{
    const Colour t = relative_xyz(linear);
    const float x = lab_curve(t[0]), y = lab_curve(t[1]), z = lab_curve(t[2]);
    const float lightness = 116 * y - 16, scale = 0.01f * lightness;
    return {lightness, scale * 500 * (x - y), scale * 200 * (y - z)};
}

float hyab(const Colour &a, const Colour &b)
{
    const float da = a[1] - b[1], db = a[2] - b[2];
    return std::fabs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

float largest_difference() { return std::pow(hyab(hunt_lab_of({0, 1, 0}), hunt_lab_of({0, 0, 1})), 0.7f); }

}  // namespace parity::flip
