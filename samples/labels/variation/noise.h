// The noise of a camera's sensor.
#pragma once

#include <cstdint>
#include <vector>

namespace labels
{

// Adds noise to each number of the picture by itself; its standard deviation in 255ths is sqrt(read^2 + shot^2 v) for a
// value v of [0, 1]. Nearly a normal distribution, without what is beyond 3.4 deviations.
void add_noise(std::vector<uint8_t> &rgb, double read, double shot, uint64_t seed, uint32_t sample);

}  // namespace labels
