#include "samples/hosts/osg/plugin/steps.h"

#include <cmath>

namespace osg_plugin
{
namespace
{

constexpr double least_m = 0.002;
constexpr double most_m = 10;  // one that is farther away a frame later was put there
constexpr int still_until_it_stands = 3;

}  // namespace

void Steps::move(double way_m, double stride_m, bool time_passed)
{
    if (way_m > most_m) return;
    if (way_m > least_m) {
        cycles_ += way_m / stride_m;
        walks_ = true;
        still_ = 0;
    } else if (time_passed && ++still_ >= still_until_it_stands) {
        walks_ = false;
    }
}

double Steps::phase() const { return cycles_ - std::floor(cycles_); }

}  // namespace osg_plugin
