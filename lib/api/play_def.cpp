#include "lib/api/play_def.h"

#include <algorithm>
#include <cmath>

#include "lib/api/boundary.h"
#include "lib/base/near_names.h"
#include "lib/crowd/edits.h"
#include "lib/crowd/gait.h"

namespace claque::api
{

using base::fail;
using model::none;

namespace
{

const model::Clip &clip_of(const model::Template &tmpl, uint32_t clip, const char *name)
{
    if (clip >= tmpl.rig.clips.size())
        fail(CLQ_ARGUMENT, "%s is clip %u, which does not exist: there are %zu in template '%s'", name, clip,
             tmpl.rig.clips.size(), tmpl.name.c_str());
    return tmpl.rig.clips[clip];
}

double share_of(const model::Clip &clip, float time_s)
{
    return (double(time_s) - double(clip.start_s)) / double(clip.duration_s);
}

void sync_by_marker(const clq_gait_def &def, const model::Template &tmpl, crowd::Gait &gait)
{
    const model::Rig &rig = tmpl.rig;
    for (size_t i = 0; i < rig.markers.size(); ++i) {
        if (rig.marker_names[i] != def.sync_marker) continue;
        const model::Marker &marker = rig.markers[i];
        if (marker.clip == def.clip_a) gait.sync_a.push_back(share_of(rig.clips[def.clip_a], marker.time_s));
        if (marker.clip == def.clip_b) gait.sync_b.push_back(share_of(rig.clips[def.clip_b], marker.time_s));
    }
    if (gait.sync_a.empty() || gait.sync_a.size() != gait.sync_b.size())
        fail(CLQ_ARGUMENT, "clips '%s' and '%s' have %zu and %zu markers '%s': equally many are wanted",
             rig.clip_names[def.clip_a].c_str(), rig.clip_names[def.clip_b].c_str(), gait.sync_a.size(),
             gait.sync_b.size(), def.sync_marker);
}

}  // namespace

crowd::Curve curve_of(const clq_curve &curve)
{
    require(number_of(curve) <= CLQ_CURVE_INERTIAL,
            "curve is none of CLQ_CURVE_LINEAR, CLQ_CURVE_SMOOTH, CLQ_CURVE_INERTIAL");
    return static_cast<crowd::Curve>(number_of(curve));
}

crowd::Gait gait_of(const clq_gait_def &def, const model::Template &tmpl, std::pmr::memory_resource *memory)
{
    const model::Clip &a = clip_of(tmpl, def.clip_a, "clip_a"), &b = clip_of(tmpl, def.clip_b, "clip_b");
    crowd::Gait gait(memory);
    gait.tmpl = &tmpl;
    gait.clip_a = def.clip_a, gait.clip_b = def.clip_b;
    if (!(a.duration_s > 0) || !(b.duration_s > 0))
        fail(CLQ_ARGUMENT, "gaits are clips with a length: these are %g and %g s long", double(a.duration_s),
             double(b.duration_s));
    require_array(def.sync_a_s, def.sync_count, "sync_a_s");
    require_array(def.sync_b_s, def.sync_count, "sync_b_s");
    for (uint32_t i = 0; i < def.sync_count; ++i) {
        gait.sync_a.push_back(share_of(a, def.sync_a_s[i]));
        gait.sync_b.push_back(share_of(b, def.sync_b_s[i]));
    }
    if (def.sync_count == 0 && def.sync_marker) sync_by_marker(def, tmpl, gait);
    crowd::check_gait(gait);
    return gait;
}

crowd::MaskOf mask_of(const clq_mask_def &def, const model::Template &tmpl, std::pmr::memory_resource *memory)
{
    const model::Rig &rig = tmpl.rig;
    require_array(def.nodes, def.node_count, "nodes");
    require(def.node_count > 0, "a mask has no nodes");
    constexpr uint32_t most_feather = 1000;
    if (def.feather > most_feather) fail(CLQ_ARGUMENT, "a feather of %u nodes: at most %u", def.feather, most_feather);
    // Distance to a named ancestor in nodes, the named node included; 0: not below any.
    model::Array<uint32_t> depth(rig.node_count(), 0u, memory);
    for (uint32_t i = 0; i < def.node_count; ++i) {
        if (!def.nodes[i]) fail(CLQ_ARGUMENT, "name %u of a mask is NULL", i);
        const uint32_t node = rig.find_node(def.nodes[i]);
        if (node == none)
            fail(CLQ_ARGUMENT, "template '%s' has no node '%s'%s", tmpl.name.c_str(), def.nodes[i],
                 base::names_near(def.nodes[i], rig.node_names).c_str());
        depth[node] = 1;
    }
    model::Array<float> weights(rig.node_count(), 0.0f, memory);
    for (uint32_t n = 0; n < rig.node_count(); ++n) {
        const uint32_t parent = rig.parents[n];
        if (parent != none && depth[parent] > 0)
            depth[n] = depth[n] ? std::max(depth[n], depth[parent] + 1) : depth[parent] + 1;
        const float inside =
            depth[n] > def.feather ? 1.0f : static_cast<float>(depth[n]) / static_cast<float>(def.feather + 1);
        weights[n] = def.inverted ? 1 - inside : inside;
    }
    return crowd::checked_mask(tmpl, std::move(weights));
}

crowd::Layer layer_of(const clq_layer_def &def, const model::Template &tmpl)
{
    require(number_of(def.kind) <= CLQ_LAYER_ADD, "kind is neither CLQ_LAYER_REPLACE nor CLQ_LAYER_ADD");
    crowd::Layer layer;
    layer.additive = number_of(def.kind) == CLQ_LAYER_ADD;
    layer.play = {def.play.clip, def.play.start_s, def.play.speed, def.play.phase_s};
    crowd::check_play(layer.play, tmpl);
    layer.weight = def.weight;
    layer.start_s = def.play.start_s;
    layer.fade_in_s = def.fade_in_s, layer.fade_out_s = def.fade_out_s;
    layer.curve = curve_of(def.curve);
    layer.mask = def.mask.index1 ? def.mask.index1 - 1 : none;
    const bool moves = def.play.clip != CLQ_NONE;
    if (!(def.loops >= 0) || !std::isfinite(def.loops))
        fail(CLQ_ARGUMENT, "a layer of %g loops: 0 or more is wanted", double(def.loops));
    if (def.loops > 0) {
        const double length = moves ? double(tmpl.rig.clips[def.play.clip].duration_s) : 0;
        const double speed = std::fabs(double(def.play.speed));
        if (!(length > 0) || !(speed > 0))
            fail(CLQ_ARGUMENT, "a layer of %g loops of a clip that stands still", double(def.loops));
        layer.end_s = layer.start_s + double(def.loops) * length / speed;
    }
    if (def.has_reference) {
        layer.reference_clip = def.reference_clip == CLQ_NONE ? none : def.reference_clip;
        layer.reference_time_s = double(def.reference_time_s);
    } else if (moves && layer.additive) {
        layer.reference_clip = def.play.clip;
        layer.reference_time_s = double(tmpl.rig.clips[def.play.clip].start_s);
    }
    return layer;
}

}  // namespace claque::api
