#include "lib/pose/exact.h"

#include <algorithm>

#include "lib/pose/blend.h"
#include "lib/pose/channel.h"

namespace claque::pose
{

namespace
{

void apply(const model::Rig &rig, const model::Channel &channel, KeyInterval place, const LocalPose &out)
{
    switch (channel.target) {
        case model::ChannelTarget::translation:
            sample_numbers(rig, channel, place, &out.nodes[channel.node].translation.x);
            break;
        case model::ChannelTarget::rotation:
            out.nodes[channel.node].rotation = sample_rotation(rig, channel, place);
            break;
        case model::ChannelTarget::scale:
            sample_numbers(rig, channel, place, &out.nodes[channel.node].scale.x);
            break;
        case model::ChannelTarget::morph_weights:
            sample_numbers(rig, channel, place, out.weights + rig.morph_sets[channel.node].first_weight);
            break;
    }
}

void replace(math::Trs &below, const math::Trs &to, float weight)
{
    below.translation += weight * (to.translation - below.translation);
    below.scale += weight * (to.scale - below.scale);
    below.rotation = nlerp(below.rotation, to.rotation, weight);
}

void add(math::Trs &below, const math::Trs &to, const math::Trs &from, float weight)
{
    below.translation += weight * (to.translation - from.translation);
    below.scale += weight * (to.scale - from.scale);
    below.rotation = add_rotation(below.rotation, from.rotation, to.rotation, weight);
}

float mask_of(const Layer &layer, uint32_t node) { return layer.mask ? layer.mask[node] : 1.0f; }

void mix_weights(const model::Rig &rig, const Layer &layer, const LocalPose &out, const LocalPose &to,
                 const LocalPose &from)
{
    for (const model::MorphSet &set : rig.morph_sets) {
        const float weight = layer.weight * mask_of(layer, set.node);
        for (uint32_t i = set.first_weight; i < set.first_weight + set.target_count; ++i)
            out.weights[i] +=
                weight * (to.weights[i] - (layer.kind == LayerKind::add ? from.weights[i] : out.weights[i]));
    }
}

}  // namespace

void sample_exact(const model::Rig &rig, uint32_t clip_index, double time_s, const uint8_t *active,
                  const LocalPose &out)
{
    std::copy(rig.rest.begin(), rig.rest.end(), out.nodes);
    std::copy(rig.rest_weights.begin(), rig.rest_weights.end(), out.weights);
    if (clip_index == model::none) return;
    const model::Clip &clip = rig.clips[clip_index];
    // Channels often share their key times, so the last key interval is reused.
    const model::Channel *last = nullptr;
    KeyInterval place;
    for (uint32_t i = 0; i < clip.channel_count; ++i) {
        const model::Channel &channel = rig.channels[clip.first_channel + i];
        if (active && channel.target != model::ChannelTarget::morph_weights && !active[channel.node]) continue;
        if (!last || channel.first_time != last->first_time || channel.key_count != last->key_count)
            place = find_key(rig.times.data() + channel.first_time, channel.key_count, time_s);
        apply(rig, channel, place, out);
        last = &channel;
    }
}

void sample_layers(const model::Rig &rig, base::Span<const Layer> layers, const uint8_t *active, const LocalPose &out,
                   const LocalPose &spare, const LocalPose &reference)
{
    sample_exact(rig, model::none, 0, active, out);
    for (const Layer &layer : layers) {
        const bool adds = layer.kind == LayerKind::add;
        sample_exact(rig, layer.clip, layer.time_s, active, spare);
        if (adds) sample_exact(rig, layer.reference_clip, layer.reference_time_s, active, reference);
        for (uint32_t n = 0; n < rig.node_count(); ++n) {
            const float weight = layer.weight * mask_of(layer, n);
            if (weight == 0) continue;
            if (adds) add(out.nodes[n], spare.nodes[n], reference.nodes[n], weight);
            else if (weight == 1) out.nodes[n] = spare.nodes[n];
            else replace(out.nodes[n], spare.nodes[n], weight);
        }
        mix_weights(rig, layer, out, spare, reference);
    }
}

}  // namespace claque::pose
