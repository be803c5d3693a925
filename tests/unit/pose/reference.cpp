#include "reference.h"

#include <algorithm>
#include <cmath>

namespace claque::reference
{

namespace
{

std::vector<double> group(const model::Rig &rig, const model::Channel &c, uint32_t index)
{
    const float *v = rig.values.data() + c.first_value + size_t(index) * c.component_count;
    return std::vector<double>(v, v + c.component_count);
}

void normalise(std::vector<double> &q)
{
    double square = 0;
    for (const double x : q) square += x * x;
    for (double &x : q) x /= std::sqrt(square);
}

std::vector<double> slerp(std::vector<double> a, std::vector<double> b, double t)
{
    normalise(a), normalise(b);
    double d = 0;
    for (int i = 0; i < 4; ++i) d += a[i] * b[i];
    const double s = d < 0 ? -1 : 1, angle = std::acos(std::min(1.0, std::fabs(d)));
    if (angle < 1e-10) return a;
    std::vector<double> out(4);
    for (int i = 0; i < 4; ++i)
        out[i] = std::sin(angle * (1 - t)) / std::sin(angle) * a[i] + s * std::sin(angle * t) / std::sin(angle) * b[i];
    return out;
}

std::vector<double> sample(const model::Rig &rig, const model::Channel &c, double time)
{
    const float *t = rig.times.data() + c.first_time;
    const bool cubic = c.interpolation == model::Interpolation::cubic_spline;
    const auto value = [&](uint32_t key) { return group(rig, c, cubic ? 3 * key + 1 : key); };
    const bool rotation = c.target == model::ChannelTarget::rotation;
    std::vector<double> out;
    uint32_t k = 0;
    while (k + 1 < c.key_count && double(t[k + 1]) <= time) ++k;
    if (time <= t[0] || k + 1 == c.key_count || c.interpolation == model::Interpolation::step) {
        out = value(time <= t[0] ? 0 : k);
    } else {
        const double td = double(t[k + 1]) - t[k], u = (time - t[k]) / td, u2 = u * u, u3 = u2 * u;
        const std::vector<double> a = value(k), b = value(k + 1);
        if (!cubic && rotation) return slerp(a, b, u);
        const std::vector<double> out_tangent = cubic ? group(rig, c, 3 * k + 2) : a;
        const std::vector<double> in_tangent = cubic ? group(rig, c, 3 * k + 3) : a;
        for (size_t i = 0; i < a.size(); ++i)
            out.push_back(cubic ? (2 * u3 - 3 * u2 + 1) * a[i] + td * (u3 - 2 * u2 + u) * out_tangent[i] +
                                      (-2 * u3 + 3 * u2) * b[i] + td * (u3 - u2) * in_tangent[i]
                                : (1 - u) * a[i] + u * b[i]);
    }
    if (rotation) normalise(out);
    return out;
}

Mat4 local_of(const Node &n)
{
    const double x = n.r[0], y = n.r[1], z = n.r[2], w = n.r[3];
    const double r[9] = {1 - 2 * (y * y + z * z), 2 * (x * y + w * z),     2 * (x * z - w * y),
                         2 * (x * y - w * z),     1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
                         2 * (x * z + w * y),     2 * (y * z - w * x),     1 - 2 * (x * x + y * y)};
    Mat4 out{};
    for (int c = 0; c < 3; ++c)
        for (int k = 0; k < 3; ++k) out.m[4 * c + k] = r[3 * c + k] * n.s[c];
    for (int k = 0; k < 3; ++k) out.m[12 + k] = n.t[k];
    out.m[15] = 1;
    return out;
}

}  // namespace

Mat4 mul(const Mat4 &a, const Mat4 &b)
{
    Mat4 out{};
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            for (int k = 0; k < 4; ++k) out.m[4 * c + r] += a.m[4 * k + r] * b.m[4 * c + k];
    return out;
}

Mat4 mat_of(const math::Affine &a)
{
    Mat4 out{};
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 3; ++r) out.m[4 * c + r] = a.c[3 * c + r];
    out.m[15] = 1;
    return out;
}

Locals locals_at(const model::Rig &rig, uint32_t clip, double time_s)
{
    Locals out;
    for (const math::Trs &trs : rig.rest) {
        out.nodes.push_back({{trs.translation.x, trs.translation.y, trs.translation.z},
                             {trs.rotation.x, trs.rotation.y, trs.rotation.z, trs.rotation.w},
                             {trs.scale.x, trs.scale.y, trs.scale.z}});
    }
    out.weights.assign(rig.rest_weights.begin(), rig.rest_weights.end());
    for (uint32_t i = 0; clip != model::none && i < rig.clips[clip].channel_count; ++i) {
        const model::Channel &c = rig.channels[rig.clips[clip].first_channel + i];
        const std::vector<double> v = sample(rig, c, time_s);
        if (c.target == model::ChannelTarget::translation) out.nodes[c.node].t = v;
        if (c.target == model::ChannelTarget::rotation) out.nodes[c.node].r = v;
        if (c.target == model::ChannelTarget::scale) out.nodes[c.node].s = v;
        if (c.target == model::ChannelTarget::morph_weights)
            std::copy(v.begin(), v.end(), out.weights.begin() + rig.morph_sets[c.node].first_weight);
    }
    return out;
}

Pose pose_of(const model::Rig &rig, const Locals &locals)
{
    Pose out;
    out.weights = locals.weights;
    std::vector<Mat4> globals;
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        const Mat4 local = local_of(locals.nodes[i]);
        globals.push_back(rig.parents[i] == model::none ? local : mul(globals[rig.parents[i]], local));
    }
    for (const model::PaletteEntry &entry : rig.palette)
        out.palette.push_back(mul(globals[entry.node], mat_of(entry.inverse_bind)));
    return out;
}

Pose evaluate(const model::Rig &rig, uint32_t clip, double time_s)
{
    return pose_of(rig, locals_at(rig, clip, time_s));
}

}  // namespace claque::reference
