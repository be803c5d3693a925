#include "lib/figures/charts.h"

#include <array>

namespace claque::figures
{

namespace
{

// The face has the most room: about 1.3 mm a texel.
constexpr std::array<ChartRect, chart_count> rects = {{
    {0, 0, 304, 240},      // head
    {304, 216, 52, 24},    // ear
    {356, 216, 52, 24},    //
    {0, 240, 176, 272},    // tunic front
    {176, 240, 152, 272},  // tunic back
    {328, 484, 184, 28},   // tunic inside
    {304, 172, 104, 44},   // sleeve
    {408, 172, 104, 44},   //
    {408, 216, 52, 24},    // sleeve inside
    {460, 216, 52, 24},    //
    {304, 112, 104, 60},   // arm
    {408, 112, 104, 60},   //
    {304, 0, 104, 56},     // hand back
    {408, 0, 104, 56},     //
    {304, 56, 104, 56},    // hand palm
    {408, 56, 104, 56},    //
    {328, 240, 92, 104},   // leg
    {420, 240, 92, 104},   //
    {328, 344, 76, 140},   // foot
    {404, 344, 76, 140},   //
    {480, 344, 16, 140},   // sole
    {496, 344, 16, 140},   //
}};

model::Zone make(const char *name, int key, std::array<float, 3> colour, model::HsbRange range)
{
    model::Zone zone;
    zone.name = name;
    zone.key = static_cast<uint8_t>(key);
    zone.colour = colour;
    zone.range = range;
    return zone;
}

}  // namespace

ChartRect rect_of(Chart chart) { return rects[static_cast<size_t>(chart)]; }

uint8_t key_of(Zone zone) { return static_cast<uint8_t>(16 + 32 * static_cast<int>(zone)); }

model::Zone zone_of(Zone zone)
{
    const int key = key_of(zone);
    switch (zone) {
        case Zone::skin:
            return make("skin", key, {0.86f, 0.65f, 0.52f}, {16, 28, 0.34f, 0.52f, 0.58f, 0.95f});
        case Zone::hair:
            return make("hair", key, {0.33f, 0.23f, 0.16f}, {12, 38, 0.15f, 0.62f, 0.12f, 0.52f});
        case Zone::eyes:
            return make("eyes", key, {0.93f, 0.91f, 0.87f}, {20, 220, 0.02f, 0.12f, 0.88f, 1.00f});
        case Zone::lips:
            return make("lips", key, {0.74f, 0.45f, 0.40f}, {4, 15, 0.38f, 0.50f, 0.55f, 0.78f});
        case Zone::tunic:
            return make("tunic", key, {0.93f, 0.88f, 0.77f}, {12, 54, 0.04f, 0.52f, 0.58f, 1.00f});
        case Zone::belt:
            return make("belt", key, {0.42f, 0.26f, 0.15f}, {12, 34, 0.40f, 0.72f, 0.24f, 0.55f});
        case Zone::border:
            return make("border", key, {0.60f, 0.16f, 0.14f}, {330, 36, 0.50f, 0.82f, 0.30f, 0.68f});
        case Zone::sandals:
            break;
    }
    return make("sandals", key, {0.47f, 0.30f, 0.18f}, {14, 36, 0.40f, 0.70f, 0.28f, 0.58f});
}

}  // namespace claque::figures
