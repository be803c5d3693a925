// The memory that arrays hold, for statistics.
#pragma once

#include <cstdint>

namespace claque::base
{

// Bytes of the arrays' capacities.
template <class... Arrays>
uint64_t held_bytes(const Arrays &...arrays)
{
    return (uint64_t(0) + ... + (uint64_t(arrays.capacity()) * sizeof(*arrays.data())));
}

}  // namespace claque::base
