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

// A stable counting sort by one digit.
template <class Number>
void radix_sort_by(Number number, std::pmr::vector<SortEntry> &listed, std::pmr::vector<SortEntry> &spare)
{
    uint32_t differing = 0;  // bits
    for (const SortEntry &one : listed) differing |= number(one) ^ number(listed[0]);
    for (uint32_t digit = 0; digit < digits; ++digit) {
        if ((differing >> (digit * digit_bits) & ((1u << digit_bits) - 1)) == 0) continue;
        const auto digit_of = [&](const SortEntry &one) {
            return number(one) >> (digit * digit_bits) & ((1u << digit_bits) - 1);
        };
        std::array<uint32_t, 1u << digit_bits> offsets{};
        for (const SortEntry &one : listed) ++offsets[digit_of(one)];
        uint32_t before = 0;
        for (uint32_t &offset : offsets) before += std::exchange(offset, before);
        for (const SortEntry &one : listed) spare[offsets[digit_of(one)]++] = one;
        listed.swap(spare);
    }
}

// Monotonic in a non-negative number: its exponent and the first three bits of its fraction.
uint32_t band_of(float number)
{
    uint32_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    return bits >> 20;
}

}  // namespace

void sort_entries(std::pmr::vector<SortEntry> &listed, std::pmr::vector<SortEntry> &spare)
{
    if (listed.empty()) return;
    spare.resize(listed.size());
    const auto row_of = [](const SortEntry &one) { return one.row; };
    if (!std::is_sorted(listed.begin(), listed.end(),
                        [](const SortEntry &a, const SortEntry &b) { return a.row < b.row; }))
        radix_sort_by(row_of, listed, spare);
    radix_sort_by([](const SortEntry &one) { return band_of(one.distance); }, listed, spare);
    radix_sort_by([](const SortEntry &one) { return one.texture_set; }, listed, spare);
    radix_sort_by([](const SortEntry &one) { return one.tmpl; }, listed, spare);
}

}  // namespace claque::frame
