#include "lib/model/root_motion.h"

#include <cmath>

#include "lib/math/trig.h"

namespace claque::model
{

namespace
{

GroundTransform sample(const Rig &rig, const RootCurve &curve, uint32_t i)
{
    const float *s = rig.root_samples.data() + 3 * (size_t(curve.first_sample) + i);
    return {static_cast<double>(s[0]), static_cast<double>(s[1]), static_cast<double>(s[2])};
}

// `share` is the fraction of the clip in [0, 1].
GroundTransform within(const Rig &rig, const RootCurve &curve, double share)
{
    const double at = share * (curve.sample_count - 1);
    uint32_t i = static_cast<uint32_t>(at);
    if (i > curve.sample_count - 2) i = curve.sample_count - 2;
    const double f = at - i;
    const GroundTransform a = sample(rig, curve, i), b = sample(rig, curve, i + 1);
    return {a.x + f * (b.x - a.x), a.z + f * (b.z - a.z), a.yaw + f * (b.yaw - a.yaw)};
}

}  // namespace

GroundTransform compose(const GroundTransform &outer, const GroundTransform &inner)
{
    const double c = math::cos(outer.yaw), s = math::sin(outer.yaw);
    return {outer.x + c * inner.x + s * inner.z, outer.z - s * inner.x + c * inner.z, outer.yaw + inner.yaw};
}

GroundTransform inverse(const GroundTransform &step)
{
    const double c = math::cos(step.yaw), s = math::sin(step.yaw);
    return {-(c * step.x - s * step.z), -(s * step.x + c * step.z), -step.yaw};
}

// The translations of the repeated steps form a geometric series of rotations.
GroundTransform repeated(const GroundTransform &step, double times)
{
    const double half = 0.5 * step.yaw, s = math::sin(half);
    GroundTransform out;
    out.yaw = times * step.yaw;
    if (std::fabs(s) < 1e-9) {
        out.x = times * step.x, out.z = times * step.z;
        return out;
    }
    const double length = math::sin(times * half) / s, turn = (times - 1) * half;
    const GroundTransform turned = compose({0, 0, turn}, {length * step.x, length * step.z, 0});
    out.x = turned.x, out.z = turned.z;
    return out;
}

GroundTransform root_motion(const Rig &rig, uint32_t clip, double from_s, double to_s)
{
    for (const RootCurve &curve : rig.root_curves) {
        if (curve.clip != clip) continue;
        const double start = static_cast<double>(rig.clips[clip].start_s);
        const double length = static_cast<double>(rig.clips[clip].duration_s);
        if (!(length > 0)) return GroundTransform();
        const double from = (from_s - start) / length, to = (to_s - start) / length;
        const double rounds = std::floor(to) - std::floor(from);
        const GroundTransform round = repeated(within(rig, curve, 1), rounds);
        const GroundTransform last = compose(round, within(rig, curve, to - std::floor(to)));
        return compose(inverse(within(rig, curve, from - std::floor(from))), last);
    }
    return GroundTransform();
}

}  // namespace claque::model
