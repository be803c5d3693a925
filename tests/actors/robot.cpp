#include "tests/actors/robot.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/hash.h"
#include "lib/crowd/edits.h"
#include "meshsplit/build.h"

namespace actors
{

namespace
{

struct Box {
    Node node;
    const char *name;
    glm::vec3 low, high;  // in the node's frame
    float first_m, last_m;
};

constexpr float everywhere = std::numeric_limits<float>::infinity();

void add_box(model::Model &model, const Box &box)
{
    model::Part part;
    part.name = box.name;
    part.node = box.node;
    part.lod_min_m = box.first_m, part.lod_max_m = box.last_m;
    part.material = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const uint32_t first = static_cast<uint32_t>(part.positions.size());
            for (int corner = 0; corner < 4; ++corner) {
                glm::vec3 p = box.low, n(0);
                p[axis] = side ? box.high[axis] : box.low[axis];
                p[u] = corner == 1 || corner == 2 ? box.high[u] : box.low[u];
                p[v] = corner >= 2 ? box.high[v] : box.low[v];
                n[axis] = side ? 1.0f : -1.0f;
                part.positions.push_back(p);
                part.normals.push_back(n);
            }
            const uint32_t order[2][6] = {{0, 2, 1, 0, 3, 2}, {0, 1, 2, 0, 2, 3}};
            for (const uint32_t k : order[side]) part.indices.push_back(first + k);
        }
    uint32_t entry = 0;
    while (entry < model.rig.palette.size() && model.rig.palette[entry].node != box.node) ++entry;
    if (entry == model.rig.palette.size()) {
        model::PaletteEntry made;
        made.node = box.node;
        model.rig.palette.push_back(made);
    }
    part.joints.assign(part.positions.size(), entry);
    part.weights.assign(part.positions.size(), 1.0f);
    model.parts.push_back(part);
}

void add_node(model::Model &model, const char *name, uint32_t parent, const glm::vec3 &at, float deactivation_m)
{
    math::Trs rest;
    rest.translation = at;
    model.rig.parents.push_back(parent);
    model.rig.rest.push_back(rest);
    model.rig.node_names.emplace_back(name);
    model.rig.deactivation_m.push_back(deactivation_m);
}

void add_dof(model::Model &model, const char *name, Node node, model::DofKind kind, const glm::vec3 &axis, float first,
             float last)
{
    model::Dof dof;
    dof.node = node, dof.kind = kind, dof.axis = axis, dof.min = first, dof.max = last;
    model.rig.dofs.push_back(dof);
    model.rig.dof_names.emplace_back(name);
}

// A clip of one second in which the left arm goes up and down and the whole robot bobs.
void add_clip(model::Model &model)
{
    model::Rig &rig = model.rig;
    for (const float t : {0.0f, 0.5f, 1.0f}) rig.times.push_back(t);
    model::Channel bob;
    bob.node = body, bob.target = model::ChannelTarget::translation, bob.key_count = 3;
    for (const float y : {0.9f, 1.0f, 0.9f}) rig.values.insert(rig.values.end(), {0.0f, y, 0.0f});
    model::Channel lift;
    lift.node = arm_left, lift.target = model::ChannelTarget::rotation, lift.component_count = 4, lift.key_count = 3;
    lift.first_value = 9;
    for (const float angle : {0.0f, 2.0f, 0.0f})
        rig.values.insert(rig.values.end(), {0.0f, 0.0f, std::sin(angle / 2), std::cos(angle / 2)});
    rig.channels = {bob, lift};
    model::Clip clip;
    clip.channel_count = 2, clip.duration_s = 1;
    rig.clips.push_back(clip);
    rig.clip_names.emplace_back("wave");
}

}  // namespace

model::Model robot_model()
{
    model::Model model;
    model.name = "robot";
    add_node(model, "body", model::none, {0, 0.9f, 0}, everywhere);
    add_node(model, "chest", body, {0, 0.3f, 0}, limbs_stop_m);
    add_node(model, "neck", chest, {0, 0.4f, 0}, limbs_stop_m);
    add_node(model, "head", neck, {0, 0.1f, 0}, limbs_stop_m);
    add_node(model, "arm_left", chest, {0.3f, 0.3f, 0}, limbs_stop_m);
    add_node(model, "hand_left", arm_left, {0.6f, 0, 0}, hands_stop_m);
    add_node(model, "arm_right", chest, {-0.3f, 0.3f, 0}, limbs_stop_m);
    add_node(model, "hand_right", arm_right, {-0.6f, 0, 0}, hands_stop_m);
    add_node(model, "leg_left", body, {0.12f, 0, 0}, limbs_stop_m);
    add_node(model, "leg_right", body, {-0.12f, 0, 0}, limbs_stop_m);
    model::Zone zone;
    zone.name = "paint", zone.key = 0, zone.colour = {0.8f, 0.3f, 0.2f};
    model.zones.push_back(zone);
    model::Material material;
    material.zone = 0;
    model.materials.push_back(material);
    const float h = hands_stop_m, l = limbs_stop_m;
    for (const Box &box : {Box{body, "hips", {-0.2f, -0.1f, -0.12f}, {0.2f, 0.3f, 0.12f}, 0, l},
                           Box{chest, "chest", {-0.28f, 0, -0.15f}, {0.28f, 0.38f, 0.15f}, 0, l},
                           Box{neck, "neck", {-0.06f, 0, -0.06f}, {0.06f, 0.12f, 0.06f}, 0, l},
                           Box{head, "head", {-0.12f, 0, -0.13f}, {0.12f, 0.28f, 0.13f}, 0, l},
                           Box{arm_left, "arm left", {0, -0.07f, -0.07f}, {0.6f, 0.07f, 0.07f}, 0, h},
                           Box{hand_left, "hand left", {0, -0.09f, -0.05f}, {0.2f, 0.09f, 0.05f}, 0, h},
                           Box{arm_left, "arm and hand left", {0, -0.07f, -0.07f}, {0.8f, 0.07f, 0.07f}, h, l},
                           Box{arm_right, "arm right", {-0.6f, -0.07f, -0.07f}, {0, 0.07f, 0.07f}, 0, h},
                           Box{hand_right, "hand right", {-0.2f, -0.09f, -0.05f}, {0, 0.09f, 0.05f}, 0, h},
                           Box{arm_right, "arm and hand right", {-0.8f, -0.07f, -0.07f}, {0, 0.07f, 0.07f}, h, l},
                           Box{leg_left, "leg left", {-0.09f, -0.9f, -0.1f}, {0.09f, 0, 0.1f}, 0, l},
                           Box{leg_right, "leg right", {-0.09f, -0.9f, -0.1f}, {0.09f, 0, 0.1f}, 0, l},
                           Box{body, "whole", {-0.25f, -0.9f, -0.13f}, {0.25f, 1.0f, 0.13f}, l, everywhere}})
        add_box(model, box);
    add_dof(model, "chest_yaw", chest, model::DofKind::rotation, {0, 1, 0}, -0.6f, 0.6f);
    add_dof(model, "neck_yaw", neck, model::DofKind::rotation, {0, 1, 0}, -1.0f, 1.0f);
    add_dof(model, "neck_pitch", neck, model::DofKind::rotation, {-1, 0, 0}, -0.5f, 0.5f);
    add_dof(model, "head_slide", head, model::DofKind::translation, {0, 0, 1}, -0.05f, 0.1f);
    add_dof(model, "arm_left_lift", arm_left, model::DofKind::rotation, {0, 0, 1}, -1.4f, 1.4f);
    add_dof(model, "arm_right_lift", arm_right, model::DofKind::rotation, {0, 0, -1}, -1.4f, 1.4f);
    add_dof(model, "leg_left_swing", leg_left, model::DofKind::rotation, {1, 0, 0}, -0.8f, 0.8f);
    add_dof(model, "leg_right_swing", leg_right, model::DofKind::rotation, {1, 0, 0}, -0.8f, 0.8f);
    add_clip(model);
    return model;
}

std::unique_ptr<model::Template> make_robot()
{
    auto tmpl = std::make_unique<model::Template>(std::pmr::get_default_resource());
    meshsplit::build(robot_model(), meshsplit::BuildOptions(), *tmpl);
    return tmpl;
}

World::World(const frame::Settings &settings, uint64_t seed)
    : tmpl(make_robot()),
      crowd(std::pmr::get_default_resource(), seed),
      frame(std::pmr::get_default_resource(), settings)
{
}

glm::quat turned(float yaw_rad) { return glm::quat(std::cos(yaw_rad / 2), 0, std::sin(yaw_rad / 2), 0); }

double random_unit(uint64_t series, uint64_t k)
{
    return static_cast<double>(base::unit(base::mix(base::mix(series + 1) ^ (k + 1))));
}

crowd::Id World::add(const glm::dvec3 &at, float yaw_rad, uint64_t seed)
{
    crowd::Transform place;
    place.position = at;
    place.orientation = turned(yaw_rad);
    crowd::Play play;
    play.clip = 0;
    ids.push_back(crowd::create(crowd, *tmpl, place, play, seed));
    return ids.back();
}

frame::View &World::look(const glm::dvec3 &eye, const glm::dvec3 &target, float fov_y_rad, float aspect)
{
    views.push_back(std::make_unique<frame::View>(std::pmr::get_default_resource()));
    views.back()->camera = frame::look_at(eye, target, glm::vec3(0, 1, 0), fov_y_rad, aspect, 0.1f, 2000);
    return *views.back();
}

void World::update(double time_s)
{
    std::vector<frame::View *> all;
    for (const auto &view : views) all.push_back(view.get());
    const base::Status status =
        frame::update(crowd, frame, base::Span<frame::View *const>(all.data(), static_cast<uint32_t>(all.size())),
                      time_s, base::Jobs());
    ASSERT_TRUE(status.ok()) << status.text;
}

uint64_t World::hash() const
{
    uint64_t h = base::fnv_start;
    for (const auto &view : views) {
        const uint64_t one = frame::hash(view->list);
        h = base::fnv(h, &one, sizeof one);
    }
    return h;
}

}  // namespace actors
