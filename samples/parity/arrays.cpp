#include "samples/parity/arrays.h"

#include <algorithm>
#include <cmath>

#include "samples/parity/ulp.h"

namespace parity
{
namespace
{

constexpr double degrees_per_radian = 57.295779513082320877;

bool finite(const float *v) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }

double distance(const float *a, const float *b)
{
    const double x = double(a[0]) - b[0], y = double(a[1]) - b[1], z = double(a[2]) - b[2];
    return std::sqrt(x * x + y * y + z * z);
}

// Uses sine and cosine, because an arc cosine would lose small angles.
double angle_degrees(const float *a, const float *b)
{
    const double x = double(a[1]) * b[2] - double(a[2]) * b[1];
    const double y = double(a[2]) * b[0] - double(a[0]) * b[2];
    const double z = double(a[0]) * b[1] - double(a[1]) * b[0];
    const double dot = double(a[0]) * b[0] + double(a[1]) * b[1] + double(a[2]) * b[2];
    const float none[3] = {};
    const bool no_a = distance(a, none) == 0, no_b = distance(b, none) == 0;
    if (no_a || no_b) return no_a && no_b ? 0 : 180;
    return std::atan2(std::sqrt(x * x + y * y + z * z), dot) * degrees_per_radian;
}

template <class Measure>
Deviation deviation(const std::vector<float> &reference, const std::vector<float> &result,
                    const std::vector<Span> &spans, Measure measure)
{
    Deviation d;
    double squares = 0;
    std::vector<uint32_t> ulps;
    for (const Span &span : spans)
        for (size_t i = 0; i < span.count; ++i) {
            const float *a = &reference[3 * (span.reference_first + i)], *b = &result[3 * (span.result_first + i)];
            ++d.compared;
            if (!finite(a) || !finite(b)) {
                ++d.not_finite;
                continue;
            }
            for (int c = 0; c < 3; ++c) {
                ulps.push_back(ulp_distance(a[c], b[c]));
                if (ulps.back() > d.ulp_max) d.ulp_max = ulps.back(), d.ulp_reference = a[c], d.ulp_result = b[c];
            }
            const double apart = measure(a, b);
            squares += apart * apart;
            if (span.size_m > 0) d.max_relative = std::max(d.max_relative, apart / span.size_m);
            if (apart <= d.max) continue;
            d.max = apart;
            d.worst_actor = span.actor;
            d.worst_vertex = i;
        }
    if (ulps.empty()) return d;
    d.rms = std::sqrt(squares / static_cast<double>(d.compared - d.not_finite));
    const auto middle = ulps.begin() + static_cast<std::ptrdiff_t>(ulps.size() / 2);
    std::nth_element(ulps.begin(), middle, ulps.end());
    d.ulp_median = *middle;
    return d;
}

}  // namespace

Deviation positions_deviation(const std::vector<float> &reference, const std::vector<float> &result,
                              const std::vector<Span> &spans)
{
    return deviation(reference, result, spans, distance);
}

Deviation normals_deviation(const std::vector<float> &reference, const std::vector<float> &result,
                            const std::vector<Span> &spans)
{
    return deviation(reference, result, spans, angle_degrees);
}

}  // namespace parity
