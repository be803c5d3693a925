#include "lib/pose/clock.h"

#include <cmath>

namespace claque::pose
{

double clip_time(const ClipClock &clock, const model::Clip &clip, double time_s)
{
    const double start = clip.start_s, length = clip.duration_s;
    if (!(length > 0)) return start;
    const double gone = double(clock.phase_s) + double(clock.speed) * (time_s - clock.start_s);
    if (!std::isfinite(gone)) return start;
    // fmod is exact: after ten million seconds the only loss is the rounding of the sum above.
    double within = std::fmod(gone, length);
    if (within < 0) within += length;
    if (within >= length) within = 0;
    return start + within;
}

}  // namespace claque::pose
