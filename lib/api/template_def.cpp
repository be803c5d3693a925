#include "lib/api/template_def.h"

#include <cmath>
#include <map>

#include "lib/api/boundary.h"

namespace claque::api
{

using base::fail;

namespace
{

const char *name_of(const char *name) { return name ? name : ""; }

void require_array(const void *array, uint32_t count, const char *what)
{
    if (count && !array) fail(CLQ_ARGUMENT, "%s is NULL with a count of %u", what, count);
}

bool all_zero(const float *values, int count)
{
    for (int i = 0; i < count; ++i)
        if (values[i] != 0) return false;
    return true;
}

void add_nodes(const clq_template_def &def, model::Model &model)
{
    require_array(def.nodes, def.node_count, "nodes");
    for (uint32_t i = 0; i < def.node_count; ++i) {
        const clq_node_def &node = def.nodes[i];
        math::Trs trs;
        trs.translation = glm::vec3(node.translation[0], node.translation[1], node.translation[2]);
        const float *q = node.rotation_xyzw;
        if (!all_zero(q, 4)) trs.rotation = glm::quat(q[3], q[0], q[1], q[2]);
        if (!all_zero(node.scale, 3)) trs.scale = glm::vec3(node.scale[0], node.scale[1], node.scale[2]);
        model.rig.parents.push_back(node.parent);
        model.rig.rest.push_back(trs);
        model.rig.node_names.emplace_back(name_of(node.name));
    }
}

void add_joints(const clq_template_def &def, model::Model &model)
{
    require_array(def.joints, def.joint_count, "joints");
    for (uint32_t i = 0; i < def.joint_count; ++i) {
        model::PaletteEntry entry;
        entry.node = def.joints[i].node;
        if (const float *m = def.joints[i].inverse_bind)
            for (int k = 0; k < 4; ++k)
                entry.inverse_bind.set_column(k, glm::vec3(m[4 * k], m[4 * k + 1], m[4 * k + 2]));
        model.rig.palette.push_back(entry);
    }
}

void add_looks(const clq_template_def &def, model::Model &model)
{
    require_array(def.images, def.image_count, "images");
    require_array(def.zones, def.zone_count, "zones");
    require_array(def.materials, def.material_count, "materials");
    for (uint32_t i = 0; i < def.image_count; ++i) {
        const clq_image_def &image = def.images[i];
        if (image.width_px < 1 || image.width_px > 16384 || image.height_px < 1 || image.height_px > 16384 ||
            !image.rgba)
            fail(CLQ_ARGUMENT, "image %u '%s' is %u x %u pixels: 1 to 16384 and an array are wanted", i,
                 name_of(image.name), image.width_px, image.height_px);
        model::Image made;
        made.name = name_of(image.name);
        made.width = image.width_px;
        made.height = image.height_px;
        made.rgba.assign(image.rgba, image.rgba + 4ull * image.width_px * image.height_px);
        made.alpha = image.alpha == CLQ_ALPHA_ZONE_KEYS ? model::AlphaMeaning::zone_keys : model::AlphaMeaning::opacity;
        model.images.push_back(std::move(made));
    }
    for (uint32_t i = 0; i < def.zone_count; ++i) {
        const clq_zone_def &zone = def.zones[i];
        if (zone.key > 255)
            fail(CLQ_ARGUMENT, "zone %u '%s' has key %u: keys are 0 to 255", i, name_of(zone.name), zone.key);
        model::Zone made;
        made.name = name_of(zone.name);
        made.key = static_cast<uint8_t>(zone.key);
        made.colour = {zone.colour[0], zone.colour[1], zone.colour[2]};
        made.range = range_of(zone.range);
        model.zones.push_back(std::move(made));
    }
    for (uint32_t i = 0; i < def.material_count; ++i) {
        const clq_material_def &material = def.materials[i];
        model::Material made;
        made.name = name_of(material.name);
        const float *c = material.base_colour;
        if (!all_zero(c, 4)) made.base_colour = {c[0], c[1], c[2], c[3]};
        made.image = material.image;
        made.wrap_s = static_cast<model::Wrap>(material.wrap_s);
        made.wrap_t = static_cast<model::Wrap>(material.wrap_t);
        if (static_cast<unsigned>(material.wrap_s) > 2 || static_cast<unsigned>(material.wrap_t) > 2)
            fail(CLQ_ARGUMENT, "material %u '%s' has a wrap mode that is none", i, name_of(material.name));
        made.alpha_mode = material.alpha_mode == CLQ_ALPHA_MASK ? model::AlphaMode::mask : model::AlphaMode::opaque;
        made.alpha_cutoff = material.alpha_cutoff;
        made.double_sided = material.double_sided != 0;
        made.zone = material.zone;
        model.materials.push_back(std::move(made));
    }
}

template <class V>
void take(std::vector<V> &out, const float *values, uint32_t count)
{
    if (!values) return;
    out.resize(count);
    for (uint32_t i = 0; i < count; ++i)
        for (int k = 0; k < static_cast<int>(sizeof(V) / sizeof(float)); ++k)
            out[i][k] = values[static_cast<size_t>(i) * (sizeof(V) / sizeof(float)) + k];
}

class PartReader
{
public:
    PartReader(const clq_template_def &def, model::Model &model) : def_(def), model_(model) {}

    void read(uint32_t index)
    {
        const clq_part_def &part = def_.parts[index];
        model::Part made;
        made.name = name_of(part.name);
        made.node = part.node;
        made.material = part.material;
        if (!part.positions || part.vertex_count == 0)
            fail(CLQ_ARGUMENT, "part %u '%s' has no positions", index, made.name.c_str());
        if (part.index_count % 3 || (part.index_count == 0 && part.vertex_count % 3))
            fail(CLQ_ARGUMENT, "part %u '%s' has %u indices and %u vertices: three a triangle", index,
                 made.name.c_str(), part.index_count, part.vertex_count);
        require_array(part.indices, part.index_count, "indices");
        take(made.positions, part.positions, part.vertex_count);
        take(made.normals, part.normals, part.vertex_count);
        take(made.uvs, part.uvs, part.vertex_count);
        if (part.colours)
            for (uint32_t v = 0; v < part.vertex_count; ++v)
                made.colours.push_back({part.colours[4ull * v], part.colours[4ull * v + 1], part.colours[4ull * v + 2],
                                        part.colours[4ull * v + 3]});
        if (part.index_count) made.indices.assign(part.indices, part.indices + part.index_count);
        read_influences(part, made, index);
        read_morphs(part, made, index);
        model_.parts.push_back(std::move(made));
    }

private:
    void read_influences(const clq_part_def &part, model::Part &made, uint32_t index)
    {
        made.skinned = part.influence_count > 0;
        if (!made.skinned) {
            if (part.node >= def_.node_count)
                fail(CLQ_ARGUMENT, "rigid part %u '%s' hangs on node %u of %u", index, made.name.c_str(), part.node,
                     def_.node_count);
            made.influence_count = 1;
            made.joints.assign(part.vertex_count, rigid_entry(part.node));
            made.weights.assign(part.vertex_count, 1.0f);
            return;
        }
        if (part.influence_count > 64)
            fail(CLQ_ARGUMENT, "part %u '%s' has %u influences a vertex: at most 64", index, made.name.c_str(),
                 part.influence_count);
        if (!part.joints || !part.weights)
            fail(CLQ_ARGUMENT, "skinned part %u '%s' lacks joints or weights", index, made.name.c_str());
        const size_t count = static_cast<size_t>(part.influence_count) * part.vertex_count;
        made.influence_count = part.influence_count;
        made.joints.assign(part.joints, part.joints + count);
        made.weights.assign(part.weights, part.weights + count);
    }

    uint32_t rigid_entry(uint32_t node)
    {
        const auto found = rigid_entries_.find(node);
        if (found != rigid_entries_.end()) return found->second;
        model::PaletteEntry entry;
        entry.node = node;
        model_.rig.palette.push_back(entry);
        return rigid_entries_[node] = static_cast<uint32_t>(model_.rig.palette.size() - 1);
    }

    void read_morphs(const clq_part_def &part, model::Part &made, uint32_t index)
    {
        if (part.morph_count == 0) return;
        require_array(part.morphs, part.morph_count, "morphs");
        if (part.node >= def_.node_count)
            fail(CLQ_ARGUMENT, "morphed part %u '%s' names node %u of %u", index, made.name.c_str(), part.node,
                 def_.node_count);
        made.morph_set = morph_set(part);
        for (uint32_t m = 0; m < part.morph_count; ++m) {
            model::MorphTarget target;
            take(target.positions, part.morphs[m].positions, part.vertex_count);
            take(target.normals, part.morphs[m].normals, part.vertex_count);
            made.morphs.push_back(std::move(target));
        }
    }

    uint32_t morph_set(const clq_part_def &part)
    {
        for (uint32_t i = 0; i < model_.rig.morph_sets.size(); ++i)
            if (model_.rig.morph_sets[i].node == part.node) return i;
        model::MorphSet set;
        set.node = part.node;
        set.first_weight = static_cast<uint32_t>(model_.rig.rest_weights.size());
        set.target_count = part.morph_count;
        for (uint32_t m = 0; m < part.morph_count; ++m) model_.rig.rest_weights.push_back(part.morphs[m].rest_weight);
        model_.rig.morph_sets.push_back(set);
        return static_cast<uint32_t>(model_.rig.morph_sets.size() - 1);
    }

    const clq_template_def &def_;
    model::Model &model_;
    std::map<uint32_t, uint32_t> rigid_entries_;
};

void add_channel(const clq_channel_def &channel, model::Model &model, uint32_t clip, uint32_t index)
{
    if (channel.key_count == 0 || !channel.times_s || !channel.values)
        fail(CLQ_ARGUMENT, "channel %u of clip %u has no keys", index, clip);
    if (static_cast<unsigned>(channel.path) > 3 || static_cast<unsigned>(channel.interpolation) > 2)
        fail(CLQ_ARGUMENT, "channel %u of clip %u has a path or interpolation that is none", index, clip);
    model::Channel made;
    made.path = static_cast<model::Path>(channel.path);
    made.interpolation = static_cast<model::Interpolation>(channel.interpolation);
    made.node = channel.node;
    made.component_count = channel.path == CLQ_PATH_ROTATION ? 4 : 3;
    if (channel.path == CLQ_PATH_MORPH_WEIGHTS) {
        made.node = model::none;
        for (uint32_t i = 0; i < model.rig.morph_sets.size(); ++i)
            if (model.rig.morph_sets[i].node == channel.node) {
                made.node = i;
                made.component_count = static_cast<uint16_t>(model.rig.morph_sets[i].target_count);
            }
        if (made.node == model::none)
            fail(CLQ_ARGUMENT, "channel %u of clip %u animates morph weights of node %u, which has no morphed part",
                 index, clip, channel.node);
    }
    const size_t groups = made.interpolation == model::Interpolation::cubic_spline ? 3 : 1;
    made.first_time = static_cast<uint32_t>(model.rig.times.size());
    made.key_count = channel.key_count;
    made.first_value = static_cast<uint32_t>(model.rig.values.size());
    model.rig.times.insert(model.rig.times.end(), channel.times_s, channel.times_s + channel.key_count);
    model.rig.values.insert(model.rig.values.end(), channel.values,
                            channel.values + groups * channel.key_count * made.component_count);
    model.rig.channels.push_back(made);
}

void add_clips(const clq_template_def &def, model::Model &model)
{
    require_array(def.clips, def.clip_count, "clips");
    for (uint32_t i = 0; i < def.clip_count; ++i) {
        const clq_clip_def &clip = def.clips[i];
        require_array(clip.channels, clip.channel_count, "channels");
        model::Clip made;
        made.first_channel = static_cast<uint32_t>(model.rig.channels.size());
        made.channel_count = clip.channel_count;
        float first = 0, last = 0;
        for (uint32_t c = 0; c < clip.channel_count; ++c) {
            add_channel(clip.channels[c], model, i, c);
            const clq_channel_def &channel = clip.channels[c];
            first = c == 0 ? channel.times_s[0] : std::fmin(first, channel.times_s[0]);
            last = c == 0 ? channel.times_s[channel.key_count - 1]
                          : std::fmax(last, channel.times_s[channel.key_count - 1]);
        }
        made.start_s = first;
        made.duration_s = last - first;
        model.rig.clips.push_back(made);
        model.rig.clip_names.emplace_back(name_of(clip.name));
    }
}

}  // namespace

model::HsbRange range_of(const clq_hsb_range &r)
{
    return {r.hue_first_deg,   r.hue_last_deg,     r.saturation_first,
            r.saturation_last, r.brightness_first, r.brightness_last};
}

clq_hsb_range range_of(const model::HsbRange &r)
{
    return {r.hue_first_deg,   r.hue_last_deg,     r.saturation_first,
            r.saturation_last, r.brightness_first, r.brightness_last};
}

model::Model model_of(const clq_template_def &def)
{
    model::Model model;
    model.name = name_of(def.name);
    add_nodes(def, model);
    add_joints(def, model);
    add_looks(def, model);
    require_array(def.parts, def.part_count, "parts");
    PartReader reader(def, model);
    for (uint32_t i = 0; i < def.part_count; ++i) reader.read(i);
    add_clips(def, model);
    return model;
}

}  // namespace claque::api
