// Where each piece of the surface lies in the texture, and what the texture means by its keys.
#pragma once

#include <cstdint>

#include "lib/model/model.h"

namespace claque::figures
{

constexpr int texture_size = 512;

enum class Zone : uint8_t { skin, hair, eyes, lips, tunic, belt, border, sandals };
constexpr int zone_count = 8;

// Pieces that exist twice are named for the figure's own left; the right one follows it.
enum class Chart : uint8_t {
    head,
    ear,
    ear_r,
    tunic_front,
    tunic_back,
    tunic_inside,
    sleeve,
    sleeve_r,
    sleeve_inside,
    sleeve_inside_r,
    arm,
    arm_r,
    hand_back,
    hand_back_r,
    hand_palm,
    hand_palm_r,
    leg,
    leg_r,
    foot,
    foot_r,
    sole,
    sole_r
};
constexpr int chart_count = 22;

enum class Side : int8_t { right = -1, left = 1 };

constexpr Chart on(Side side, Chart left)
{
    return side == Side::left ? left : static_cast<Chart>(static_cast<int>(left) + 1);
}

// In texels of the texture: the outline with its gutter.
struct ChartRect {
    int x, y, width, height;
};
ChartRect rect_of(Chart chart);

uint8_t key_of(Zone zone);
model::Zone zone_of(Zone zone);  // name, key, colour by default, and what colours are drawn from

}  // namespace claque::figures
