#include "lib/pose/channel.h"

#include <algorithm>

#include "lib/math/slerp.h"

namespace claque::pose
{

namespace
{

// Hermite weights of the value, the out-tangent, the next value and the next in-tangent; tangents are per second.
struct Hermite {
    double v0, m0, v1, m1;
    Hermite(double t, double step_s)
    {
        const double t2 = t * t, t3 = t2 * t;
        v0 = 2 * t3 - 3 * t2 + 1;
        m0 = step_s * (t3 - 2 * t2 + t);
        v1 = 3 * t2 - 2 * t3;
        m1 = step_s * (t3 - t2);
    }
};

double step_after(const model::Rig &rig, const model::Channel &channel, uint32_t key)
{
    const float *times = rig.times.data() + channel.first_time;
    return double(times[key + 1]) - double(times[key]);
}

// The value of a key; cubic splines store (in-tangent, value, out-tangent) per key.
const float *value_at(const model::Rig &rig, const model::Channel &channel, uint32_t key)
{
    const uint32_t n = channel.component_count;
    const bool cubic = channel.interpolation == model::Interpolation::cubic_spline;
    return rig.values.data() + channel.first_value + (cubic ? (3 * size_t(key) + 1) * n : size_t(key) * n);
}

glm::quat unit_at(const float *v) { return math::unit_quat(v[3], v[0], v[1], v[2]); }

}  // namespace

KeyInterval find_key(const float *times, uint32_t count, double time_s)
{
    if (count < 2 || !(time_s > times[0])) return {0, 0};
    if (time_s >= times[count - 1]) return {count - 1, 0};
    const double span = double(times[count - 1]) - double(times[0]);
    const double guess = (time_s - times[0]) / span * (count - 1);
    uint32_t key = std::min(static_cast<uint32_t>(guess), count - 2);
    if (!(times[key] <= time_s && time_s < times[key + 1])) {
        // With a uniform rate, rounding shifts the guess by at most one key; other rates need a search.
        if (time_s < times[key] && times[key - 1] <= time_s) {
            --key;
        } else if (time_s >= times[key + 1] && key + 2 < count && time_s < times[key + 2]) {
            ++key;
        } else {
            key = static_cast<uint32_t>(std::upper_bound(times, times + count, time_s) - times) - 1;
        }
    }
    return {key, (time_s - times[key]) / (double(times[key + 1]) - double(times[key]))};
}

void sample_numbers(const model::Rig &rig, const model::Channel &channel, KeyInterval place, float *out)
{
    const uint32_t n = channel.component_count;
    const float *a = value_at(rig, channel, place.key);
    if (place.f == 0 || channel.interpolation == model::Interpolation::step) {
        std::copy(a, a + n, out);
        return;
    }
    const float *b = value_at(rig, channel, place.key + 1);
    if (channel.interpolation == model::Interpolation::linear) {
        const double p = 1 - place.f, q = place.f;
        for (uint32_t i = 0; i < n; ++i) out[i] = static_cast<float>(p * a[i] + q * b[i]);
        return;
    }
    const Hermite h(place.f, step_after(rig, channel, place.key));
    const float *out_tangent = a + n, *in_tangent = b - n;
    for (uint32_t i = 0; i < n; ++i)
        out[i] = static_cast<float>(h.v0 * a[i] + h.m0 * out_tangent[i] + h.v1 * b[i] + h.m1 * in_tangent[i]);
}

glm::quat sample_rotation(const model::Rig &rig, const model::Channel &channel, KeyInterval place)
{
    const float *a = value_at(rig, channel, place.key);
    if (place.f == 0 || channel.interpolation == model::Interpolation::step) return unit_at(a);
    const float *b = value_at(rig, channel, place.key + 1);
    if (channel.interpolation == model::Interpolation::linear) return math::slerp(a, b, place.f);
    const Hermite h(place.f, step_after(rig, channel, place.key));
    double q[4];
    for (int i = 0; i < 4; ++i) q[i] = h.v0 * a[i] + h.m0 * a[4 + i] + h.v1 * b[i] + h.m1 * b[i - 4];
    return math::unit_quat(q[3], q[0], q[1], q[2]);
}

}  // namespace claque::pose
