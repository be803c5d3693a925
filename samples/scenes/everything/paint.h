// The images of the figure of `everything`.
#pragma once

#include <cstdint>
#include <vector>

namespace scenes::everything
{

enum Zone : uint32_t { gown, trim, sash, skin, hat, lantern, cape_cloth, zone_count };

constexpr uint32_t image_px = 64;

// Of the gown: alpha holds keys. The two sets have the same zones in other patterns.
enum class Pattern { zigzag, chequers };
std::vector<uint8_t> gown_image(Pattern pattern);
uint32_t key_of(Zone zone);

// Of the cape: alpha is opacity, 0 in round holes.
std::vector<uint8_t> cape_image();

}  // namespace scenes::everything
