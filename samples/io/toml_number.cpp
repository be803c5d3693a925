#include "samples/io/toml_number.h"

#include <cmath>

namespace io
{
namespace
{

constexpr uint64_t first_gap = uint64_t(1) << 53;  // every whole number up to here is a double

bool is_held(int64_t value)
{
    const double held = static_cast<double>(value);
    return held < 0x1p63 && static_cast<int64_t>(held) == value;
}

}  // namespace

double number_in(const toml::node &node, std::string &wrong)
{
    wrong.clear();
    if (const toml::value<int64_t> *whole = node.as_integer()) {
        if (is_held(whole->get())) return static_cast<double>(whole->get());
        wrong = "is " + std::to_string(whole->get()) + ", a whole number that would be rounded: up to " +
                std::to_string(first_gap) + " none is";
        return NAN;
    }
    const toml::value<double> *real = node.as_floating_point();
    if (!real) wrong = "is not a number";
    else if (!std::isfinite(real->get())) wrong = "is not finite";
    return real ? real->get() : NAN;
}

}  // namespace io
