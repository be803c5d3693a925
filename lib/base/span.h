// A view of an array of T that another object owns, for the arguments and results of jobs.
#pragma once

#include <cstdint>

namespace claque::base
{

template <class T>
struct Span {
    T *data = nullptr;
    uint32_t count = 0;

    constexpr Span() = default;
    constexpr Span(T *first, uint32_t length) : data(first), count(length) {}
    template <class Container>
    explicit constexpr Span(Container &container)
        : data(container.data()), count(static_cast<uint32_t>(container.size()))
    {
    }

    constexpr T &operator[](uint32_t i) const { return data[i]; }
    constexpr T *begin() const { return data; }
    constexpr T *end() const { return data + count; }
    constexpr bool empty() const { return count == 0; }
};

}  // namespace claque::base
