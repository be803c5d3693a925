#include "tests/api/arrays_of_model.h"

#include <cmath>

namespace claque::test
{

namespace
{

clq_channel_def channel_of(const model::Rig &rig, const model::Channel &channel)
{
    clq_channel_def out{};
    out.node = channel.target == model::ChannelTarget::morph_weights ? rig.morph_sets[channel.node].node : channel.node;
    out.target = static_cast<clq_channel_target>(channel.target);
    out.interpolation = static_cast<clq_interpolation>(channel.interpolation);
    out.key_count = channel.key_count;
    out.times_s = rig.times.data() + channel.first_time;
    out.values = rig.values.data() + channel.first_value;
    return out;
}

}  // namespace

ArraysOfModel::ArraysOfModel(const model::Model &model) : def(clq_template_def_init())
{
    add_rig(model);
    add_looks(model);
    for (const model::Part &part : model.parts)
        if (!part.hidden) add_part(model, part);
    add_clips(model);
    add_notes(model);
    def.name = model.name.c_str();
    def.node_count = static_cast<uint32_t>(nodes_.size());
    def.nodes = nodes_.data();
    def.joint_count = static_cast<uint32_t>(joints_.size());
    def.joints = joints_.data();
    def.image_count = static_cast<uint32_t>(images_.size());
    def.images = images_.data();
    def.zone_count = static_cast<uint32_t>(zones_.size());
    def.zones = zones_.data();
    def.material_count = static_cast<uint32_t>(materials_.size());
    def.materials = materials_.data();
    def.part_count = static_cast<uint32_t>(parts_.size());
    def.parts = parts_.data();
    def.clip_count = static_cast<uint32_t>(clips_.size());
    def.clips = clips_.data();
    def.dof_count = static_cast<uint32_t>(dofs_.size());
    def.dofs = dofs_.data();
    def.marker_count = static_cast<uint32_t>(markers_.size());
    def.markers = markers_.data();
    def.root_motion_count = static_cast<uint32_t>(root_motions_.size());
    def.root_motions = root_motions_.data();
    for (const model::TextureSet &set : model.texture_sets)
        texture_sets_.push_back({set.name.c_str(), set.images.data()});
    def.texture_set_count = static_cast<uint32_t>(texture_sets_.size());
    def.texture_sets = texture_sets_.data();
}

void ArraysOfModel::add_rig(const model::Model &model)
{
    const model::Rig &rig = model.rig;
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        const math::Trs &t = rig.rest[i];
        clq_node_def node{};
        node.name = rig.node_names[i].c_str();
        node.parent = rig.parents[i];
        for (int k = 0; k < 3; ++k) node.translation[k] = t.translation[k], node.scale[k] = t.scale[k];
        // Three zeros would mean "no scale given": a node that a file shrinks to nothing stays next to nothing.
        if (t.scale == glm::vec3(0)) node.scale[0] = 1e-20f;
        node.rotation_xyzw[0] = t.rotation.x, node.rotation_xyzw[1] = t.rotation.y;
        node.rotation_xyzw[2] = t.rotation.z, node.rotation_xyzw[3] = t.rotation.w;
        const float deactivation_m = rig.deactivation_of(i);
        node.deactivation_m = std::isfinite(deactivation_m) ? deactivation_m : 0;
        nodes_.push_back(node);
    }
    for (uint32_t i = 0; i < rig.dofs.size(); ++i) {
        const model::Dof &d = rig.dofs[i];
        const bool morphs = d.kind == model::DofKind::morph;
        dofs_.push_back({rig.dof_names[i].c_str(),
                         morphs ? rig.morph_sets[d.node].node : d.node,
                         static_cast<clq_dof_kind>(d.kind),
                         d.morph_target,
                         {d.axis.x, d.axis.y, d.axis.z},
                         d.min,
                         d.max,
                         d.rest});
    }
    for (const model::PaletteEntry &entry : rig.palette) {
        const float *c = entry.inverse_bind.c;
        inverse_binds_.push_back(
            {c[0], c[1], c[2], 0, c[3], c[4], c[5], 0, c[6], c[7], c[8], 0, c[9], c[10], c[11], 1});
        joints_.push_back({entry.node, inverse_binds_.back().data()});
    }
}

void ArraysOfModel::add_looks(const model::Model &model)
{
    for (const model::Image &image : model.images)
        images_.push_back({image.name.c_str(), image.width, image.height, image.rgba.data(),
                           image.alpha == model::AlphaMeaning::zone_keys ? CLQ_ALPHA_ZONE_KEYS : CLQ_ALPHA_OPACITY});
    for (const model::Zone &zone : model.zones) {
        const model::HsbRange &r = zone.range;
        zones_.push_back(
            {zone.name.c_str(),
             zone.key,
             {zone.colour[0], zone.colour[1], zone.colour[2]},
             {r.hue_min_deg, r.hue_max_deg, r.saturation_min, r.saturation_max, r.brightness_min, r.brightness_max}});
    }
    for (const model::Material &m : model.materials) {
        clq_material_def material{};
        material.name = m.name.c_str();
        for (size_t k = 0; k < 4; ++k) material.base_colour[k] = m.base_colour[k];
        if (m.base_colour == std::array<float, 4>{0, 0, 0, 0}) material.base_colour[3] = 1;  // black, not the default
        material.image = m.image;
        material.wrap_s = static_cast<clq_wrap>(m.wrap_s);
        material.wrap_t = static_cast<clq_wrap>(m.wrap_t);
        material.alpha_mode = m.alpha_mode == model::AlphaMode::mask ? CLQ_ALPHA_MASK : CLQ_ALPHA_OPAQUE;
        material.alpha_cutoff = m.alpha_cutoff;
        material.double_sided = m.double_sided;
        material.zone = m.zone;
        materials_.push_back(material);
    }
}

void ArraysOfModel::add_part(const model::Model &model, const model::Part &part)
{
    const std::vector<std::array<uint32_t, 3>> triangles = model::triangles_of(part);
    if (triangles.empty()) return;
    indices_.emplace_back();
    for (const auto &t : triangles) indices_.back().insert(indices_.back().end(), t.begin(), t.end());

    clq_part_def out{};
    out.name = part.name.c_str();
    out.node = part.morphs.empty() ? part.node : model.rig.morph_sets[part.morph_set].node;
    out.material = part.material;
    out.vertex_count = static_cast<uint32_t>(part.positions.size());
    out.positions = &part.positions[0].x;
    out.normals = part.normals.empty() ? nullptr : &part.normals[0].x;
    out.uvs = part.uvs.empty() ? nullptr : &part.uvs[0].x;
    out.colours = part.colours.empty() ? nullptr : part.colours[0].data();
    out.influence_count = part.influence_count;
    out.joints = part.joints.data();
    out.weights = part.weights.data();
    out.lod_min_m = part.lod_min_m;
    if (std::isfinite(part.lod_max_m)) out.lod_max_m = part.lod_max_m;
    out.index_count = static_cast<uint32_t>(indices_.back().size());
    out.indices = indices_.back().data();
    if (!part.morphs.empty()) {
        const model::MorphSet &set = model.rig.morph_sets[part.morph_set];
        morphs_.emplace_back();
        for (size_t m = 0; m < part.morphs.size(); ++m) {
            const model::MorphTarget &target = part.morphs[m];
            morphs_.back().push_back({target.positions.empty() ? nullptr : &target.positions[0].x,
                                      target.normals.empty() ? nullptr : &target.normals[0].x,
                                      model.rig.rest_weights[set.first_weight + m]});
        }
        out.morph_count = static_cast<uint32_t>(part.morphs.size());
        out.morphs = morphs_.back().data();
    }
    parts_.push_back(out);
}

void ArraysOfModel::add_clips(const model::Model &model)
{
    const model::Rig &rig = model.rig;
    // A morph set whose parts were all left out is unknown to the template: so are the channels that animate it.
    std::vector<bool> morphed(rig.node_count(), false);
    for (const clq_part_def &part : parts_)
        if (part.morph_count) morphed[part.node] = true;
    std::vector<uint32_t> counts;
    for (const model::Clip &clip : rig.clips) {
        const size_t before = channels_.size();
        for (uint32_t c = 0; c < clip.channel_count; ++c) {
            const clq_channel_def channel = channel_of(rig, rig.channels[clip.first_channel + c]);
            if (channel.target != CLQ_CHANNEL_MORPH_WEIGHTS || morphed[channel.node]) channels_.push_back(channel);
        }
        counts.push_back(static_cast<uint32_t>(channels_.size() - before));
    }
    size_t first = 0;
    for (size_t i = 0; i < rig.clips.size(); ++i) {
        clips_.push_back({rig.clip_names[i].c_str(), counts[i], channels_.data() + first});
        first += counts[i];
    }
}

void ArraysOfModel::add_notes(const model::Model &model)
{
    const model::Rig &rig = model.rig;
    for (size_t i = 0; i < rig.markers.size(); ++i)
        markers_.push_back({rig.markers[i].clip, rig.markers[i].time_s, rig.marker_names[i].c_str()});
    for (const model::RootMotionRequest &motion : model.root_motions)
        root_motions_.push_back({motion.clip, motion.node});
}

}  // namespace claque::test
