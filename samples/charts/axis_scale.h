// The scale of an axis: which numbers stand along it, and where a value lies.
#pragma once

#include <string>
#include <vector>

namespace charts
{

enum class Scale { linear, logarithmic };

struct AxisScale {
    Scale scale = Scale::linear;
    double from = 0, to = 1;
    std::vector<double> ticks;  // within from and to

    double share(double value) const;  // 0 at `from`, 1 at `to`
};

// Whether a linear ruler reaches to zero whatever its values, so that heights compare, or only where it is not far.
enum class Zero { always, near };

// Ends at ticks: round numbers, or powers of ten and 2 and 5 times these for logarithmic rulers, whose values must be above
// zero. About `most` steps, and one more at most.
AxisScale axis_scale_of(Scale scale, double least, double largest, int most, Zero zero);

// Steps of 1, 2 or 5 times a power of ten, so that at most `most` of them reach `largest`.
double tick_step(double largest, int most);

// As many digits as tell the ticks apart; thousands in groups of three.
std::string tick_text(const AxisScale &axis_scale, double tick);
std::string number_text(double value, int digits);

}  // namespace charts
