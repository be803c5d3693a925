#include "growing_models.h"

#include <string>

namespace claque::testing
{
namespace
{

using model::Model;

constexpr uint32_t of_net = 40;  // triangles, where something else grows
constexpr uint32_t image_px = 16;

Model net_with_nodes(uint32_t count, bool in_a_row)
{
    Model model = net_of(of_net);
    for (uint32_t i = 0; i < count; ++i) add_node(model, in_a_row ? model.rig.node_count() - 1 : 0);
    return model;
}

void add_clip(Model &model)
{
    model::Clip &clip = model.rig.clips.emplace_back();
    clip.first_channel = static_cast<uint32_t>(model.rig.channels.size());
    model.rig.clip_names.emplace_back(("c" + std::to_string(model.rig.clips.size())).c_str());
}

// Of the last clip: a node that moves to and fro.
void add_channel(Model &model, uint32_t node, uint32_t keys)
{
    model::Rig &rig = model.rig;
    model::Channel &channel = rig.channels.emplace_back();
    channel.node = node, channel.key_count = keys;
    channel.first_time = static_cast<uint32_t>(rig.times.size());
    channel.first_value = static_cast<uint32_t>(rig.values.size());
    for (uint32_t k = 0; k < keys; ++k) {
        rig.times.push_back(float(k) / 8);
        for (const float value : {float(k % 2), float(node % 3), 0.0f}) rig.values.push_back(value);
    }
    ++rig.clips.back().channel_count;
    model::set_span(rig, rig.clips.back());
}

// A picture of keys, in columns from one zone to the next.
void add_image(Model &model, uint32_t zones)
{
    model::Image &image = model.images.emplace_back();
    image.name = "image " + std::to_string(model.images.size());
    image.width = image.height = image_px, image.alpha = model::AlphaMeaning::zone_keys;
    for (uint32_t i = 0; i < image_px * image_px; ++i) {
        const uint32_t zone = i * zones / (image_px * image_px);
        const auto red = static_cast<uint8_t>(model.images.size());
        image.rgba.insert(image.rgba.end(), {red, 200, 200, model.zones[zone].key});
    }
}

// One more triangle, of the first net's.
void add_part(Model &model, uint32_t material)
{
    model::Part part;
    part.material = material, part.node = 0, part.skinned = true, part.influence_count = 2;
    for (uint32_t v = 0; v < 3; ++v) {
        const float at = float(model.parts.size());
        part.positions.emplace_back(v == 1 ? 1.0f : 0.0f, v == 2 ? 1.0f : 0.0f, at);
        part.uvs.emplace_back(v == 1 ? 0.9f : 0.1f, v == 2 ? 0.9f : 0.1f);
        part.joints.insert(part.joints.end(), {0, 1});
        part.weights.insert(part.weights.end(), {0.5f, 0.5f});
    }
    model.parts.push_back(part);
}

Model nodes(uint32_t count) { return net_with_nodes(count, false); }

// Each moves some corners of the net.
Model joints(uint32_t count)
{
    Model model = net_with_nodes(count, false);
    for (uint32_t i = 0; i < count; ++i) model.rig.palette.push_back({2 + i, math::Affine()});
    model.parts = net_of(20 * (count / 20 + 1)).parts;
    for (size_t k = 0; k < model.parts[0].joints.size(); ++k)
        model.parts[0].joints[k] = 2 + static_cast<uint32_t>(k) % count;
    return model;
}

Model influences(uint32_t count)
{
    Model model = joints(64);
    model::Part &part = model.parts[0];
    part.influence_count = count;
    part.joints.clear(), part.weights.clear();
    for (size_t v = 0; v < part.positions.size(); ++v)
        for (uint32_t k = 0; k < count; ++k)
            part.joints.push_back(2 + static_cast<uint32_t>(v + k) % 64), part.weights.push_back(1 / float(count));
    return model;
}

Model clips(uint32_t count)
{
    Model model = net_of(of_net);
    for (uint32_t i = 0; i < count; ++i) add_clip(model), add_channel(model, 1, 2);
    return model;
}

// All moved by the first of them.
Model nodes_below_one_another(uint32_t count)
{
    Model model = net_with_nodes(count, true);
    add_clip(model), add_channel(model, 2, 2);
    return model;
}

Model keys(uint32_t count)
{
    Model model = net_of(of_net);
    add_clip(model), add_channel(model, 1, count);
    return model;
}

Model channels(uint32_t count)
{
    Model model = nodes(count);
    add_clip(model);
    for (uint32_t i = 0; i < count; ++i) add_channel(model, 2 + i, 2);
    return model;
}

Model markers(uint32_t count)
{
    Model model = clips(1);
    for (uint32_t i = 0; i < count; ++i) {
        model.rig.markers.push_back({0, 0.1f});
        model.rig.marker_names.emplace_back(("m" + std::to_string(i)).c_str());
    }
    return model;
}

Model root_motions(uint32_t count)
{
    Model model = clips(count);
    for (uint32_t i = 0; i < count; ++i) model.root_motions.push_back({i, 1});
    return model;
}

Model degrees_of_freedom(uint32_t count)
{
    Model model = nodes(count);
    for (uint32_t i = 0; i < count; ++i) {
        model::Dof dof;
        dof.node = 2 + i, dof.min = -1, dof.max = 1;
        model.rig.dofs.push_back(dof);
        model.rig.dof_names.emplace_back(("d" + std::to_string(i)).c_str());
    }
    return model;
}

Model morph_targets(uint32_t count)
{
    Model model = net_of(of_net);
    model::Part &part = model.parts[0];
    part.morph_set = 0;
    part.morphs.resize(count);
    for (uint32_t i = 0; i < count; ++i) {
        part.morphs[i].positions.resize(part.positions.size());
        part.morphs[i].positions[i % part.positions.size()] = glm::vec3(0.1f);
    }
    model.rig.morph_sets.push_back({0, 0, count});
    model.rig.rest_weights.resize(count);
    return model;
}

Model parts(uint32_t count)
{
    Model model = net_of(of_net);
    for (uint32_t i = 0; i < count; ++i) add_part(model, 0);
    return model;
}

// Each is that of a part.
Model materials(uint32_t count)
{
    Model model = net_of(of_net);
    for (uint32_t i = 0; i < count; ++i) {
        model::Material &material = model.materials.emplace_back();
        material.base_colour = {float(i % 64) / 63, float(i / 64) / 63, 0.5f, 1};
        add_part(model, i + 1);
    }
    return model;
}

// Each is that of a material, and of a part.
Model images(uint32_t count)
{
    Model model = net_of(of_net);
    for (uint32_t i = 0; i < count; ++i) {
        add_image(model, 2);
        model.materials.emplace_back().image = i + 1;
        add_part(model, i + 1);
    }
    return model;
}

Model zones_of_materials(uint32_t count)
{
    Model model = materials(count);
    for (uint32_t i = 0; i < count; ++i) {
        model.zones.emplace_back().name = "z" + std::to_string(i);
        model.materials[i + 1].zone = 2 + i;
    }
    return model;
}

Model zones_of_an_image(uint32_t count)
{
    Model model = net_of(of_net);
    model.zones.clear(), model.images.clear();
    for (uint32_t i = 0; i < count; ++i) {
        model::Zone &zone = model.zones.emplace_back();
        zone.name = "z" + std::to_string(i), zone.key = static_cast<uint8_t>(i);
    }
    add_image(model, count);
    return model;
}

Model texture_sets(uint32_t count)
{
    Model model = net_of(of_net);
    for (uint32_t i = 0; i < count; ++i) {
        add_image(model, 2);
        model.texture_sets.push_back({"s" + std::to_string(i), {i + 1}});
    }
    return model;
}

// Parts that follow each other with the distance.
Model levels(uint32_t count)
{
    Model model = net_of(of_net);
    const model::Part one = model.parts[0];
    model.parts.clear();
    for (uint32_t i = 0; i < count; ++i) {
        model.parts.push_back(one);
        model.parts[i].lod_min_m = float(i);
        if (i + 1 < count) model.parts[i].lod_max_m = float(i + 1);
    }
    return model;
}

}  // namespace

const std::vector<GrowingModel> &growing_models()
{
    static const std::vector<GrowingModel> all = {{"triangles", net_of, 3000},
                                                  {"nodes", nodes, 3000},
                                                  {"nodes below one another", nodes_below_one_another, 3000},
                                                  {"joints", joints, 3000},
                                                  {"influences", influences, 60},
                                                  {"clips", clips, 3000},
                                                  {"keys", keys, 3000},
                                                  {"channels", channels, 3000},
                                                  {"markers", markers, 3000},
                                                  {"root motions", root_motions, 3000},
                                                  {"degrees of freedom", degrees_of_freedom, 200},
                                                  {"morph targets", morph_targets, 3000},
                                                  {"parts", parts, 3000},
                                                  {"materials", materials, 3000},
                                                  {"images", images, 1000},
                                                  {"zones of materials", zones_of_materials, 1000},
                                                  {"zones of an image", zones_of_an_image, 160},
                                                  {"texture sets", texture_sets, 60},
                                                  {"levels", levels, 60}};
    return all;
}

}  // namespace claque::testing
