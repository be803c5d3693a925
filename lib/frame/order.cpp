#include "lib/frame/order.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace claque::frame
{

namespace
{

constexpr uint32_t digit_bits = 11, digits = 3;  // of 32 bits, the lowest first

// Those that have the same number stay in the order in which they came.
template <class Number>
void by(Number number, std::pmr::vector<Listed> &listed, std::pmr::vector<Listed> &spare)
{
    for (uint32_t digit = 0; digit < digits; ++digit) {
        const auto digit_of = [&](const Listed &one) {
            return number(one) >> (digit * digit_bits) & ((1u << digit_bits) - 1);
        };
        std::array<uint32_t, 1u << digit_bits> places{};
        for (const Listed &one : listed) ++places[digit_of(one)];
        if (places[digit_of(listed[0])] == listed.size()) continue;
        uint32_t before = 0;
        for (uint32_t &place : places) before += std::exchange(place, before);
        for (const Listed &one : listed) spare[places[digit_of(one)]++] = one;
        listed.swap(spare);
    }
}

// Ascends with the number, where that is not below 0: its exponent and the first three bits of its fraction.
uint32_t band_of(float number)
{
    uint32_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    return bits >> 20;
}

}  // namespace

void put_in_order(std::pmr::vector<Listed> &listed, std::pmr::vector<Listed> &spare)
{
    if (listed.empty()) return;
    spare.resize(listed.size());
    const auto row_of = [](const Listed &one) { return one.row; };
    if (!std::is_sorted(listed.begin(), listed.end(), [](const Listed &a, const Listed &b) { return a.row < b.row; }))
        by(row_of, listed, spare);
    by([](const Listed &one) { return band_of(one.distance); }, listed, spare);
    by([](const Listed &one) { return one.texture_set; }, listed, spare);
    by([](const Listed &one) { return one.tmpl; }, listed, spare);
}

}  // namespace claque::frame
