// Pictures of the town's materials, drawn by code: brightness, to be multiplied with a colour. All repeat except the
// facades.
#pragma once

#include "samples/scenes/texture.h"

namespace scenes::town
{

// The size of one repeat.
constexpr float land_metres = 11.0f, furrows_metres = 12.0f, cobbles_metres = 9.0f, water_metres = 24.0f;
constexpr float tiles_metres = 3.2f, leaves_metres = 3.0f;
constexpr double roadway_share = 0.66;  // share of a street's width between the kerbs

Image land(uint64_t seed);     // grass
Image furrows(uint64_t seed);  // rows of a crop, along u
Image cobbles(uint64_t seed);  // a street from side to side: v = 0 and 1 are its edges, pavement, kerb, stones
Image water(uint64_t seed);
Image tiles(uint64_t seed);  // courses along u, the eaves at v = 0
Image leaves(uint64_t seed);

// Bays of walls, one storey high and one window wide, in a square of four by four.
enum class Bay : uint8_t {
    door,
    shop,
    shutters,
    window,
    flowers,
    blank,
    gable,
    plinth,
    arch,
    ashlar,
    portal,
    clock,
    timber,
    timber_window,
    gate,
    planks
};
constexpr int bays_each_way = 4;
Image facades(uint64_t seed);

}  // namespace scenes::town
