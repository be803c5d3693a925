// Where each piece of the surface lies in the texture, and what the texture means by its keys.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/model/model.h"

namespace claque::figures
{

constexpr int texture_size = 512;

// `outer`: what is worn over the tunic: toga, stola and palla, cloak.
enum class Zone : uint8_t { skin, hair, eyes, lips, tunic, belt, border, sandals, outer, jewellery, wings };

// A zone of one figure; its key follows from its place in the figure's list.
struct FigureZone {
    Zone zone = Zone::skin;
    std::array<float, 3> colour = {1, 1, 1};  // by default
    model::HsbRange range;                    // what individuals' colours are drawn from
};
using Zones = std::vector<FigureZone>;  // at most ten

std::vector<model::Zone> zones_of(const Zones &zones);
uint8_t key_of(const Zones &zones, Zone zone);  // throws base::Error where the figure has none

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
    sole_r,
    own  // the first of those that a figure names for itself
};
constexpr int shared_chart_count = static_cast<int>(Chart::own), own_chart_count = 24;
constexpr int chart_count = shared_chart_count + own_chart_count;

// A chart of the figure's own: `constexpr Chart hood = own_chart(0);`. Of pairs the right one is the next.
constexpr Chart own_chart(int number) { return static_cast<Chart>(shared_chart_count + number); }

enum class Side : int8_t { right = -1, left = 1 };

constexpr Chart on(Side side, Chart left)
{
    return side == Side::left ? left : static_cast<Chart>(static_cast<int>(left) + 1);
}

// In texels of the texture: the outline with its gutter.
struct ChartRect {
    int x, y, width, height;
};

// Where a figure's charts lie in its texture; those it does not name must have no faces.
struct PlacedChart {
    Chart chart;
    ChartRect rect;
};
using Layout = std::vector<PlacedChart>;

}  // namespace claque::figures
