// The product of two colours of 8 bits. All of drawing rounds it alike; otherwise pictures would differ by a bit.
#pragma once

#include <cstdint>

namespace claque::passes
{

constexpr uint8_t product(uint8_t a, uint8_t b) { return static_cast<uint8_t>((2 * a * b + 255) / 510); }

}  // namespace claque::passes
