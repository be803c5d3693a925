#include "lib/behave/random_slots.h"

#include <cmath>

namespace claque::behave
{

namespace
{

constexpr double max_slots = 4e15;  // beyond it doubles cannot represent halves; a clock of 10^8 years stays below it

int64_t floor_of(double x)
{
    if (!(x > -max_slots)) return -static_cast<int64_t>(max_slots);
    return static_cast<int64_t>(std::floor(x < max_slots ? x : max_slots));
}

}  // namespace

RandomSlots random_slots_of(const crowd::Crowd &crowd, uint32_t row, uint32_t mechanism, base::Purpose purpose) noexcept
{
    const uint64_t actor = base::hash(crowd.seed(), crowd.actor(row).seed, purpose);
    return {base::hash(actor, mechanism, purpose), purpose};
}

Slot slot_at(double t_s, double length_s) noexcept
{
    const int64_t k = floor_of(t_s / length_s);
    return {k, static_cast<double>(k) * length_s};
}

Slot uneven_slot_at(double t_s, double length_s, const RandomSlots &random_slots) noexcept
{
    constexpr uint32_t boundary = 0xb0;  // which sample: those of a slot's content have other numbers
    const auto begin_of = [&](int64_t k) {
        return (static_cast<double>(k) + 0.5 * (random_slots.unit(k, boundary) - 0.5)) * length_s;
    };
    int64_t k = floor_of(t_s / length_s + 0.5);
    double begin = begin_of(k);
    if (t_s < begin) begin = begin_of(--k);
    return {k, begin};
}

double ease(double t_s, double length_s) noexcept
{
    if (!(t_s > 0)) return t_s >= length_s ? 1 : 0;
    if (t_s >= length_s) return 1;
    const double x = t_s / length_s;
    return x * x * (3 - 2 * x);
}

}  // namespace claque::behave
