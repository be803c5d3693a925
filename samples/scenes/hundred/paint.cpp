#include "samples/scenes/hundred/paint.h"

#include <algorithm>
#include <cmath>

namespace scenes::hundred
{
namespace
{

constexpr ZonePaint paints[cell_count] = {
    {"lacquer", {0.74f, 0.12f, 0.10f}, {350, 12, 0.75f, 0.9f, 0.6f, 0.8f}},
    {"belly", {0.93f, 0.80f, 0.52f}, {38, 48, 0.3f, 0.5f, 0.85f, 0.95f}},
    {"mane", {0.95f, 0.62f, 0.12f}, {28, 45, 0.7f, 0.9f, 0.85f, 1.0f}},
    {"horn", {0.93f, 0.89f, 0.78f}, {40, 50, 0.08f, 0.2f, 0.85f, 0.95f}},
    {"eye", {1.0f, 0.90f, 0.35f}, {46, 58, 0.5f, 0.75f, 0.95f, 1.0f}},
    {"gold", {0.90f, 0.68f, 0.22f}, {40, 46, 0.65f, 0.8f, 0.8f, 0.95f}},
    {"mouth", {0.70f, 0.16f, 0.20f}, {350, 6, 0.65f, 0.8f, 0.6f, 0.75f}},
};

struct House {
    clq_hsb_range lacquer, mane, belly;
};
constexpr House houses[house_count] = {
    {{352, 8, 0.82f, 0.92f, 0.62f, 0.80f}, {36, 46, 0.75f, 0.9f, 0.9f, 1.0f}, {40, 48, 0.30f, 0.45f, 0.9f, 0.97f}},
    {{152, 168, 0.70f, 0.85f, 0.40f, 0.58f}, {8, 20, 0.80f, 0.9f, 0.8f, 0.92f}, {58, 66, 0.25f, 0.4f, 0.85f, 0.95f}},
    {{208, 222, 0.72f, 0.85f, 0.52f, 0.72f}, {0, 360, 0.0f, 0.05f, 0.93f, 1.0f}, {196, 206, 0.15f, 0.25f, 0.9f, 0.97f}},
    {{40, 47, 0.78f, 0.90f, 0.85f, 0.95f}, {348, 4, 0.80f, 0.9f, 0.6f, 0.75f}, {28, 36, 0.35f, 0.5f, 0.9f, 0.97f}},
    {{276, 292, 0.50f, 0.65f, 0.42f, 0.58f},
     {318, 332, 0.50f, 0.65f, 0.85f, 0.95f},
     {290, 300, 0.1f, 0.2f, 0.85f, 0.95f}},
    {{200, 230, 0.15f, 0.30f, 0.20f, 0.30f}, {0, 8, 0.85f, 0.95f, 0.75f, 0.88f}, {36, 44, 0.6f, 0.75f, 0.75f, 0.88f}},
};

double fraction(double x) { return x - std::floor(x); }

// Rows of round scales, each darker where the one above covers it.
double scales(double u, double v)
{
    const double row = std::floor(v * 5), y = fraction(v * 5);
    const double x = fraction(u * 4 + 0.5 * std::fmod(row, 2.0)) - 0.5;
    const double rim = std::sqrt(x * x * 3.2 + y * y * 0.95);
    return rim > 0.93 ? 0.56 : 0.80 + 0.20 * rim;
}

double light_at(Cell cell, double u, double v)
{
    switch (cell) {
        case lacquer:
            return scales(u, v);
        case belly:
            return 0.74 + 0.26 * std::sqrt(fraction(v * 3));
        case mane:
            return 0.72 + 0.28 * (0.5 + 0.5 * std::sin(37 * u + 3 * std::sin(6 * v))) * (0.5 + 0.5 * v);
        case horn:
            return 0.80 + 0.20 * fraction(v * 4);
        case eye: {
            const double x = (u - 0.5) / 0.10, y = (v - 0.5) / 0.26;
            return x * x + y * y < 1 ? 0.08 : 0.95;
        }
        case gold:
            return 0.84 + 0.16 * std::sin(9.42 * v) * std::sin(9.42 * v);
        default:
            return 0.85 + 0.15 * v;
    }
}

}  // namespace

void in_cell(Cell cell, double u, double v, float (&out)[2])
{
    constexpr double inset = 0.09;
    const double x = cell % atlas_cells_wide, y = cell / atlas_cells_wide;
    out[0] = static_cast<float>((x + inset + (1 - 2 * inset) * u) / atlas_cells_wide);
    out[1] = static_cast<float>((y + inset + (1 - 2 * inset) * v) / atlas_cells_high);
}

uint32_t key_of(Cell cell) { return 30 * (cell + 1); }

std::vector<uint8_t> atlas()
{
    const uint32_t wide = atlas_cells_wide * cell_px, high = atlas_cells_high * cell_px;
    std::vector<uint8_t> rgba;
    for (uint32_t y = 0; y < high; ++y)
        for (uint32_t x = 0; x < wide; ++x) {
            const uint32_t number = y / cell_px * atlas_cells_wide + x / cell_px;
            const Cell cell = number < cell_count ? static_cast<Cell>(number) : mouth;
            const double inset = 0.09, within = 1 - 2 * inset;
            const double u = ((x % cell_px + 0.5) / cell_px - inset) / within;
            const double v = ((y % cell_px + 0.5) / cell_px - inset) / within;
            const double light = std::clamp(light_at(cell, std::clamp(u, 0.0, 1.0), std::clamp(v, 0.0, 1.0)), 0.0, 1.0);
            const uint8_t grey = static_cast<uint8_t>(255 * light + 0.5);
            rgba.insert(rgba.end(), {grey, grey, grey, static_cast<uint8_t>(key_of(cell))});
        }
    return rgba;
}

const ZonePaint &zone_paint(Cell cell) { return paints[cell]; }

std::vector<clq_hsb_range> palette_of(uint32_t house)
{
    std::vector<clq_hsb_range> palette;
    for (const ZonePaint &paint : paints) palette.push_back(paint.range);
    palette[lacquer] = houses[house].lacquer;
    palette[mane] = houses[house].mane;
    palette[belly] = houses[house].belly;
    return palette;
}

}  // namespace scenes::hundred
