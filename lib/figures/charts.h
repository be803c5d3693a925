// The charts of a figure's texture and the zones of its keys.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/model/model.h"

namespace claque::figures
{

constexpr int texture_size = 512;

// `outer`: clothes worn over the tunic: toga, stola and palla, cloak.
enum class Zone : uint8_t { skin, hair, eyes, lips, tunic, belt, border, sandals, outer, jewellery, wings };

// A zone of one figure; its key follows from its index in the figure's list.
struct FigureZone {
    Zone zone = Zone::skin;
    std::array<float, 3> colour = {1, 1, 1};  // by default
    model::HsbRange range;                    // the range that individuals' colours are sampled from
};
using Zones = std::vector<FigureZone>;  // at most ten

std::vector<model::Zone> zones_of(const Zones &zones);
uint8_t key_of(const Zones &zones, Zone zone);  // throws base::Error if the figure lacks the zone

// Charts that exist twice are named for the figure's own left side; the right one is next.
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
    own  // the first chart of the figure's own
};
constexpr int shared_chart_count = static_cast<int>(Chart::own), own_chart_count = 24;
constexpr int chart_count = shared_chart_count + own_chart_count;

// A chart of the figure's own: `constexpr Chart hood = own_chart(0);`. Of a pair the right one is next.
constexpr Chart own_chart(int number) { return static_cast<Chart>(shared_chart_count + number); }

enum class Side : int8_t { right = -1, left = 1 };

constexpr Chart on(Side side, Chart left)
{
    return side == Side::left ? left : static_cast<Chart>(static_cast<int>(left) + 1);
}

// The rectangle of a chart with its gutter, in texels.
struct ChartRect {
    int x, y, width, height;
};

// The position of a chart in the texture. Charts that are not listed must have no faces.
struct PlacedChart {
    Chart chart;
    ChartRect rect;
};
using Layout = std::vector<PlacedChart>;

}  // namespace claque::figures
