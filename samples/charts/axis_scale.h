// The scale of an axis: its ticks, and the position of a value.
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

// Zero::always extends a linear axis to zero, so that heights compare; Zero::near only if zero is not far from the
// values.
enum class Zero { always, near };

// Ends at ticks: round numbers, or for logarithmic axes powers of ten and 2 and 5 times these; their values must be
// above zero. About `most` steps, at most one more.
AxisScale axis_scale_of(Scale scale, double least, double largest, int most, Zero zero);

// Steps of 1, 2 or 5 times a power of ten, of which at most `most` reach `largest`.
double tick_step(double largest, int most);

// As many digits as distinguish the ticks; thousands in groups of three.
std::string tick_text(const AxisScale &axis_scale, double tick);
std::string number_text(double value, int digits);

}  // namespace charts
