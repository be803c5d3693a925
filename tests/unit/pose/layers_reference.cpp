#include "layers_reference.h"

#include <cmath>

namespace claque::reference
{

namespace
{

using Quat = std::vector<double>;  // x y z w

Quat times(const Quat &a, const Quat &b)
{
    return {
        a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
        a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

Quat chord(const Quat &a, const Quat &b, double w)
{
    double cosine = 0, square = 0;
    for (int i = 0; i < 4; ++i) cosine += a[i] * b[i];
    Quat out(4);
    for (int i = 0; i < 4; ++i) out[i] = (1 - w) * a[i] + (cosine < 0 ? -w : w) * b[i];
    for (const double x : out) square += x * x;
    for (double &x : out) x /= std::sqrt(square);
    return out;
}

void go(std::vector<double> &below, const std::vector<double> &to, const std::vector<double> &from, double w)
{
    const std::vector<double> was = below;
    for (size_t i = 0; i < below.size(); ++i) below[i] = was[i] + w * (to[i] - from[i]);
}

}  // namespace

Pose evaluate(const model::Rig &rig, const std::vector<pose::Layer> &layers)
{
    Locals now = locals_at(rig, model::none, 0);
    for (const pose::Layer &layer : layers) {
        const bool adds = layer.kind == pose::LayerKind::add;
        const Locals to = locals_at(rig, layer.clip, layer.time_s);
        const Locals from = locals_at(rig, layer.reference_clip, layer.reference_time_s);
        const auto weight = [&](uint32_t node) { return double(layer.weight) * (layer.mask ? layer.mask[node] : 1.0); };
        for (uint32_t n = 0; n < rig.node_count(); ++n) {
            Node &node = now.nodes[n];
            const double w = weight(n);
            go(node.t, to.nodes[n].t, adds ? from.nodes[n].t : Node(node).t, w);
            go(node.s, to.nodes[n].s, adds ? from.nodes[n].s : Node(node).s, w);
            if (adds) {
                const Quat &f = from.nodes[n].r;
                node.r = times(node.r, chord({0, 0, 0, 1}, times({-f[0], -f[1], -f[2], f[3]}, to.nodes[n].r), w));
            } else {
                node.r = chord(node.r, to.nodes[n].r, w);
            }
        }
        for (const model::MorphSet &set : rig.morph_sets)
            for (uint32_t i = set.first_weight; i < set.first_weight + set.target_count; ++i)
                now.weights[i] += weight(set.node) * (to.weights[i] - (adds ? from.weights[i] : now.weights[i]));
    }
    return pose_of(rig, now);
}

}  // namespace claque::reference
