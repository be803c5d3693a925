#include "lib/api/template_def.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/api/boundary.h"
#include "lib/api/image_def.h"
#include "lib/api/template_parts.h"

namespace claque::api
{

using base::fail;

namespace
{

void add_looks(const clq_template_def &def, model::Model &model)
{
    require_array(def.images, def.image_count, "images");
    require_array(def.zones, def.zone_count, "zones");
    require_array(def.materials, def.material_count, "materials");
    for (uint32_t i = 0; i < def.image_count; ++i) {
        const clq_image_def &image = def.images[i];
        if (!image.rgba) fail(CLQ_ARGUMENT, "image %u '%s' has no array", i, name_of(image.name));
        model.images.push_back(image_of(image, base::text_of("image %u '%s'", i, name_of(image.name))));
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
        if (number_of(material.wrap_s) > 2 || number_of(material.wrap_t) > 2 || number_of(material.alpha_mode) > 1)
            fail(CLQ_ARGUMENT, "material %u '%s' has an unknown wrap or alpha mode", i, name_of(material.name));
        model::Material made;
        made.name = name_of(material.name);
        const float *c = material.base_colour;
        if (c[0] != 0 || c[1] != 0 || c[2] != 0 || c[3] != 0) made.base_colour = {c[0], c[1], c[2], c[3]};
        made.image = material.image;
        made.wrap_s = static_cast<model::Wrap>(material.wrap_s);
        made.wrap_t = static_cast<model::Wrap>(material.wrap_t);
        made.alpha_mode = material.alpha_mode == CLQ_ALPHA_MASK ? model::AlphaMode::mask : model::AlphaMode::opaque;
        made.alpha_cutoff = material.alpha_cutoff;
        made.double_sided = material.double_sided != 0;
        made.zone = material.zone;
        model.materials.push_back(std::move(made));
    }
}

void add_texture_sets(const clq_template_def &def, model::Model &model)
{
    require_array(def.texture_sets, def.texture_set_count, "texture_sets");
    for (uint32_t i = 0; i < def.texture_set_count; ++i) {
        const clq_texture_set_def &set = def.texture_sets[i];
        require_array(set.images, def.material_count, "images of a texture set");
        model::TextureSet &made = model.texture_sets.emplace_back();
        made.name = name_of(set.name);
        if (def.material_count) made.images.assign(set.images, set.images + def.material_count);
    }
}

void add_channel(const clq_channel_def &channel, model::Model &model, uint32_t clip, uint32_t index)
{
    if (channel.key_count == 0 || !channel.times_s || !channel.values)
        fail(CLQ_ARGUMENT, "channel %u of clip %u has no keys", index, clip);
    if (number_of(channel.target) > 3 || number_of(channel.interpolation) > 2)
        fail(CLQ_ARGUMENT, "channel %u of clip %u has an unknown target or interpolation", index, clip);
    model::Channel made;
    made.target = static_cast<model::ChannelTarget>(channel.target);
    made.interpolation = static_cast<model::Interpolation>(channel.interpolation);
    made.node = channel.node;
    made.component_count = channel.target == CLQ_CHANNEL_ROTATION ? 4 : 3;
    if (channel.target == CLQ_CHANNEL_MORPH_WEIGHTS) {
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
        for (uint32_t c = 0; c < clip.channel_count; ++c) add_channel(clip.channels[c], model, i, c);
        model::set_span(model.rig, made);
        model.rig.clips.push_back(made);
        model.rig.clip_names.emplace_back(name_of(clip.name));
    }
}

// Sorts markers by clip, then by time.
void add_notes(const clq_template_def &def, model::Model &model)
{
    require_array(def.markers, def.marker_count, "markers");
    require_array(def.root_motions, def.root_motion_count, "root_motions");
    std::vector<uint32_t> order(def.marker_count);
    for (uint32_t i = 0; i < def.marker_count; ++i) {
        order[i] = i;
        if (!std::isfinite(def.markers[i].time_s))
            fail(CLQ_ARGUMENT, "marker %u '%s' has a time that is not finite", i, name_of(def.markers[i].name));
    }
    const auto key = [&](uint32_t i) { return std::make_pair(def.markers[i].clip, def.markers[i].time_s); };
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
    for (const uint32_t i : order) {
        model.rig.markers.push_back({def.markers[i].clip, def.markers[i].time_s});
        model.rig.marker_names.emplace_back(name_of(def.markers[i].name));
    }
    for (uint32_t i = 0; i < def.root_motion_count; ++i)
        model.root_motions.push_back({def.root_motions[i].clip, def.root_motions[i].node});
}

}  // namespace

model::HsbRange range_of(const clq_hsb_range &r)
{
    return {r.hue_min_deg, r.hue_max_deg, r.saturation_min, r.saturation_max, r.brightness_min, r.brightness_max};
}

clq_hsb_range range_of(const model::HsbRange &r)
{
    return {r.hue_min_deg, r.hue_max_deg, r.saturation_min, r.saturation_max, r.brightness_min, r.brightness_max};
}

model::Model model_of(const clq_template_def &def)
{
    model::Model model;
    model.name = name_of(def.name);
    add_nodes(def, model);
    add_joints(def, model);
    add_looks(def, model);
    add_texture_sets(def, model);
    add_parts(def, model);
    add_dofs(def, model);
    add_clips(def, model);
    add_notes(def, model);
    return model;
}

}  // namespace claque::api
