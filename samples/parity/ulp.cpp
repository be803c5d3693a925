#include "samples/parity/ulp.h"

#include <cmath>
#include <cstring>

namespace parity
{
namespace
{

// Maps numbers to integers in the same order, both zeros to 0.
int64_t rank_of(float value)
{
    uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    const int64_t magnitude = bits & 0x7fffffffu;
    return bits >> 31 != 0 ? -magnitude : magnitude;
}

}  // namespace

uint32_t ulp_distance(float a, float b)
{
    if (std::isnan(a) || std::isnan(b)) return ulp_most;
    const int64_t apart = rank_of(a) - rank_of(b);
    const uint64_t distance = static_cast<uint64_t>(apart < 0 ? -apart : apart);
    return distance < ulp_most ? static_cast<uint32_t>(distance) : ulp_most;
}

}  // namespace parity
