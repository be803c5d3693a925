#include "samples/charts/axis_scale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace charts
{
namespace
{

AxisScale linear(double least, double largest, int most, Zero zero)
{
    const bool far = zero == Zero::near && (least > largest / 2 || largest < least / 2);
    double bottom = far ? least : std::min(least, 0.0), top = far ? largest : std::max(largest, 0.0);
    if (!(top > bottom)) top = bottom + 1;
    const double step = tick_step(top - bottom, most);
    AxisScale axis_scale;
    const double from = std::floor(bottom / step + 1e-9), to = std::max(std::ceil(top / step - 1e-9), from + 1);
    axis_scale.from = from * step;
    axis_scale.to = to * step;
    for (double i = from; i <= to; ++i) axis_scale.ticks.push_back(i * step);
    return axis_scale;
}

double power_of_ten(int exponent)
{
    double power = 1;
    for (int i = 0; i < std::abs(exponent); ++i) power *= 10;
    return exponent < 0 ? 1 / power : power;
}

// 1, 2 and 5 times powers of ten, in order: 0 is 1, 1 is 2, 2 is 5, 3 is 10 ...
double preferred(int i)
{
    constexpr double first[] = {1, 2, 5};
    const int third = ((i % 3) + 3) % 3;
    const int exponent = (i - third) / 3;
    return exponent < 0 ? first[third] / power_of_ten(-exponent) : first[third] * power_of_ten(exponent);
}

AxisScale logarithmic(double least, double largest, int most)
{
    AxisScale axis_scale;
    axis_scale.scale = Scale::logarithmic;
    int low = -60, high = 60;
    while (preferred(low + 1) <= least * (1 + 1e-9)) ++low;
    while (preferred(high - 1) >= largest * (1 - 1e-9)) --high;
    high = std::max(high, low + 1);
    // With many decades only whole ones, then every second, third ...
    int every = 1;
    if (high - low > most) {
        low = 3 * static_cast<int>(std::floor(low / 3.0));
        high = 3 * static_cast<int>(std::ceil(high / 3.0));
        for (every = 3; (high - low) / every > most;) every += 3;
    }
    axis_scale.from = preferred(low);
    axis_scale.to = preferred(high);
    for (int i = low; i <= high; i += every) axis_scale.ticks.push_back(preferred(i));
    return axis_scale;
}

}  // namespace

double tick_step(double largest, int most)
{
    double step = 1;
    while (largest / step < most && step > 1e-12) step /= 10;
    for (int i = 0; largest / step > most * (1 + 1e-9) && i < 90; ++i) step *= i % 3 == 1 ? 2.5 : 2;  // 1, 2, 5, 10 ...
    return step;
}

AxisScale axis_scale_of(Scale scale, double least, double largest, int most, Zero zero)
{
    return scale == Scale::linear ? linear(least, largest, most, zero) : logarithmic(least, largest, most);
}

double AxisScale::share(double value) const
{
    return scale == Scale::linear ? (value - from) / (to - from)
                                  : (std::log(value) - std::log(from)) / (std::log(to) - std::log(from));
}

std::string number_text(double value, int digits)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    std::string grouped = text;
    size_t end = grouped.find('.');
    if (end == std::string::npos) end = grouped.size();
    const size_t first = grouped[0] == '-' ? 1 : 0;
    for (size_t at = end; at > first + 3;) grouped.insert(at -= 3, "\u00a0");
    return grouped;
}

std::string tick_text(const AxisScale &axis_scale, double tick)
{
    const double unit = axis_scale.scale == Scale::logarithmic ? tick : axis_scale.ticks[1] - axis_scale.ticks[0];
    int digits = 0;
    for (double scaled = unit; scaled < 1 - 1e-9 && digits < 12; scaled *= 10) ++digits;
    return number_text(std::abs(tick) < unit * 1e-6 ? 0 : tick, digits);
}

}  // namespace charts
