#include "second_evaluation.h"

namespace claque::testing_support
{

namespace
{

reference::Vec3 vec(const float *p) { return {double(p[0]), double(p[1]), double(p[2])}; }
reference::Vec3 vec(const glm::vec3 &v) { return vec(&v.x); }

reference::Node node_of(const model::Rig &rig, uint32_t index)
{
    const math::Trs &rest = rig.rest[index];
    reference::Node node;
    node.parent = rig.parents[index] == model::none ? -1 : static_cast<int>(rig.parents[index]);
    node.translation = vec(rest.translation), node.scale = vec(rest.scale);
    node.rotation = {double(rest.rotation.x), double(rest.rotation.y), double(rest.rotation.z),
                     double(rest.rotation.w)};
    return node;
}

reference::Clip clip_of(const model::Rig &rig, const model::Clip &clip)
{
    reference::Clip out;
    for (uint32_t c = clip.first_channel; c < clip.first_channel + clip.channel_count; ++c) {
        const model::Channel &from = rig.channels[c];
        const bool weights = from.target == model::ChannelTarget::morph_weights;
        reference::Channel channel;
        channel.node = weights ? rig.morph_sets[from.node].node : from.node;
        channel.path = static_cast<reference::Path>(from.target);
        channel.interpolation = static_cast<reference::Interpolation>(from.interpolation);
        channel.width = from.component_count;
        const size_t groups = from.interpolation == model::Interpolation::cubic_spline ? 3 : 1;
        const float *time = rig.times.data() + from.first_time, *value = rig.values.data() + from.first_value;
        channel.times.assign(time, time + from.key_count);
        channel.values.assign(value, value + groups * from.key_count * from.component_count);
        out.channels.push_back(std::move(channel));
    }
    return out;
}

void add_influences(const model::Level &level, reference::Part &part)
{
    for (const model::InfluenceRun &run : level.runs)
        part.influences = std::max<size_t>(part.influences, run.influences);
    part.joints.assign(part.influences * level.source_count, 0);
    part.weights.assign(part.influences * level.source_count, 0);
    for (const model::InfluenceRun &run : level.runs)
        for (uint32_t v = 0; v < run.count; ++v)
            for (uint32_t k = 0; k < run.influences; ++k) {
                const uint32_t from = run.first_influence + v * run.influences + k;
                const size_t to = part.influences * (run.first + v) + k;
                part.joints[to] = level.joints[from], part.weights[to] = double(level.weights[from]);
            }
}

void add_morphs(const model::Level &level, reference::Part &part)
{
    for (const model::MorphRange &range : level.morph_ranges) {
        if (part.targets.size() <= range.weight) part.targets.resize(range.weight + 1);
        reference::MorphTarget &target = part.targets[range.weight];
        target.positions.resize(level.source_count), target.normals.resize(level.source_count);
        for (uint32_t i = range.first; i < range.first + range.count; ++i) {
            const model::MorphDelta &delta = level.morph_deltas[i];
            target.positions[delta.vertex] = vec(delta.position), target.normals[delta.vertex] = vec(delta.normal);
        }
    }
}

}  // namespace

reference::Character character_of(const model::Template &tmpl, const model::Level &level)
{
    const model::Rig &rig = tmpl.rig;
    reference::Character out;
    for (uint32_t i = 0; i < rig.node_count(); ++i) out.nodes.push_back(node_of(rig, i));
    for (const model::MorphSet &set : rig.morph_sets) {
        const float *first = rig.rest_weights.data() + set.first_weight;
        out.nodes[set.node].morph_weights.assign(first, first + set.target_count);
    }
    reference::Skin skin;
    for (const model::PaletteEntry &entry : rig.palette) {
        reference::Mat4 bind;
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 3; ++row) bind.at(row, column) = double(entry.inverse_bind.c[3 * column + row]);
        skin.joints.push_back(entry.node), skin.inverse_binds.push_back(bind);
    }
    out.skins.push_back(skin);
    reference::Part part;
    part.skin = 0;
    for (uint32_t v = 0; v < level.source_count; ++v) {
        part.positions.push_back(vec(level.positions.data() + 3 * size_t(v)));
        part.normals.push_back(vec(level.normals.data() + 3 * size_t(v)));
    }
    add_influences(level, part), add_morphs(level, part);
    out.parts.push_back(std::move(part));
    for (const model::Clip &clip : rig.clips) out.clips.push_back(clip_of(rig, clip));
    return out;
}

}  // namespace claque::testing_support
