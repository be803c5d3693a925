// The given points on a fine grid, smoothed over about one stride: measured heads sway by 26 to 32 mm twice a second
// or less, and a body that followed them would weave.
#include <algorithm>
#include <cmath>

#include "lib/base/error.h"
#include "lib/track/build.h"

namespace claque::track
{

namespace
{

// Between points that are farther apart in time nothing is known: the way is straight.
constexpr double max_curve_s = 2.5;

// The slope of a coordinate at a point, weighted by the times to its neighbours.
double slope(base::Span<const Point> points, uint32_t i, int axis)
{
    const auto at = [&](uint32_t k) { return points[k].position[axis]; };
    const auto between = [&](uint32_t k) { return (at(k + 1) - at(k)) / (points[k + 1].time_s - points[k].time_s); };
    if (i == 0) return between(0);
    if (i + 1 == points.count) return between(i - 1);
    const double before = points[i].time_s - points[i - 1].time_s, after = points[i + 1].time_s - points[i].time_s;
    if (before > max_curve_s) return between(i);
    if (after > max_curve_s) return between(i - 1);
    return (between(i - 1) * after + between(i) * before) / (before + after);
}

double value_at(base::Span<const Point> points, uint32_t i, double time_s, int axis)
{
    const double a = points[i].position[axis], b = points[i + 1].position[axis];
    const double length = points[i + 1].time_s - points[i].time_s, t = (time_s - points[i].time_s) / length;
    if (length > max_curve_s) return a + (b - a) * t;
    const double m = slope(points, i, axis) * length, n = slope(points, i + 1, axis) * length, rise = b - a;
    return a + t * (m + t * (3 * rise - 2 * m - n + t * (m + n - 2 * rise)));
}

uint32_t samples_of(double seconds) { return static_cast<uint32_t>(seconds * fine_hz + 0.5); }

}  // namespace

void smooth(Array<double> &values, uint32_t first, uint32_t last, uint32_t half, Beyond beyond)
{
    if (half == 0 || last < first + 2) return;
    const uint32_t count = last - first + 1;
    const auto at = [&](int64_t i) {  // relative to the first value, so that large numbers cost no digits
        const int64_t end = int64_t(count) - 1, inside = i < 0 ? 0 : i > end ? end : i;
        const double edge = values[first + static_cast<size_t>(inside)] - values[first];
        if (i == inside || beyond == Beyond::still) return edge;
        const int64_t mirrored = 2 * inside - i;
        const size_t other = static_cast<size_t>(std::clamp<int64_t>(mirrored, 0, end));
        return 2 * edge - (values[first + other] - values[first]);
    };
    Array<double> sums(count + 2 * size_t(half) + 1, 0.0, values.get_allocator().resource());
    for (size_t k = 0; k + 1 < sums.size(); ++k) sums[k + 1] = sums[k] + at(int64_t(k) - half);
    const double base = values[first];
    for (uint32_t i = 0; i < count; ++i)
        values[first + i] = base + (sums[i + 2 * size_t(half) + 1] - sums[i]) / (2 * half + 1);
}

void make_grid(base::Span<const Point> points, FinePath &path)
{
    path.start_s = points[0].time_s;
    const double length = points[points.count - 1].time_s - path.start_s;
    const uint32_t steps =
        std::max(1u, static_cast<uint32_t>(std::ceil(length * fine_hz / fine_multiple))) * fine_multiple;
    if (length > 0) path.hz = steps / length;
    path.x.resize(steps + 1);
    path.first = 0, path.last = steps;
}

void make_path(base::Span<const Point> points, const BuildSettings &settings, const glm::dvec3 &origin_m,
               FinePath &path)
{
    const uint32_t count = path.count();
    path.y.resize(count), path.z.resize(count);
    uint32_t at = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const double time_s = std::min(path.start_s + i / path.hz, points[points.count - 1].time_s);
        while (at + 2 < points.count && points[at + 1].time_s <= time_s) ++at;
        glm::dvec3 p = points[at].position;
        if (points.count > 1)
            for (int axis = 0; axis < 3; ++axis) p[axis] = value_at(points, at, time_s, axis);
        p = p * settings.metres_per_unit - origin_m;
        path.x[i] = p.x, path.y[i] = p.y, path.z[i] = p.z;
    }
    if (!(settings.smooth_s > 0)) return;
    for (Array<double> *column : {&path.x, &path.y, &path.z}) {
        smooth(*column, 0, count - 1, samples_of(settings.smooth_s / 2), Beyond::mirrored);
        smooth(*column, 0, count - 1, samples_of(settings.smooth_s / 8), Beyond::mirrored);
    }
}

}  // namespace claque::track
