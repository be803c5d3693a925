#include "tests/actors/ball.h"

#include <cmath>

namespace actors
{

namespace
{

constexpr float pi = 3.14159265f;

void add_node(model::Model &model, const char *name, uint32_t parent, const glm::vec3 &at)
{
    math::Trs rest;
    rest.translation = at;
    model.rig.parents.push_back(parent);
    model.rig.rest.push_back(rest);
    model.rig.node_names.emplace_back(name);
}

// Rings of vertices at `radius` round `centre` in the node's frame: every direction has one within eleven degrees.
void add_ball(model::Model &model, uint32_t node, const glm::vec3 &centre, float radius)
{
    constexpr uint32_t rings = 12, sides = 24;
    model::Part part;
    part.name = "ball", part.node = node, part.material = 0;
    part.lod_max_m = std::numeric_limits<float>::infinity();
    for (uint32_t r = 0; r <= rings; ++r)
        for (uint32_t s = 0; s < sides; ++s) {
            const float tilt = pi * float(r) / rings, turn = 2 * pi * float(s) / sides;
            const glm::vec3 n(std::sin(tilt) * std::cos(turn), std::cos(tilt), std::sin(tilt) * std::sin(turn));
            part.normals.push_back(n);
            part.positions.push_back(centre + radius * n);
        }
    for (uint32_t r = 0; r < rings; ++r)
        for (uint32_t s = 0; s < sides; ++s) {
            const uint32_t a = r * sides + s, b = r * sides + (s + 1) % sides, c = a + sides, d = b + sides;
            if (r > 0) part.indices.insert(part.indices.end(), {a, b, c});
            if (r + 1 < rings) part.indices.insert(part.indices.end(), {b, d, c});
        }
    model::PaletteEntry entry;
    entry.node = node;
    model.rig.palette.push_back(entry);
    part.joints.assign(part.positions.size(), static_cast<uint32_t>(model.rig.palette.size()) - 1);
    part.weights.assign(part.positions.size(), 1.0f);
    model.parts.push_back(part);
}

// A clip of two seconds that turns a node by up to `angle_rad` and back.
void add_turn(model::Model &model, uint32_t node, float angle_rad)
{
    model::Rig &rig = model.rig;
    rig.times = {0, 0.5f, 1, 1.5f, 2};
    model::Channel turn;
    turn.node = node, turn.target = model::ChannelTarget::rotation, turn.component_count = 4, turn.key_count = 5;
    for (const float share : {0.0f, 0.5f, 1.0f, 0.5f, 0.0f}) {
        const float half = angle_rad * share / 2;
        rig.values.insert(rig.values.end(), {0.0f, 0.0f, std::sin(half), std::cos(half)});
    }
    rig.channels = {turn};
    model::Clip clip;
    clip.channel_count = 1, clip.duration_s = 2;
    rig.clips.push_back(clip);
    rig.clip_names.emplace_back("turn");
}

model::Model painted(const char *name)
{
    model::Model model;
    model.name = name;
    model::Zone zone;
    zone.name = "paint", zone.key = 0, zone.colour = {0.8f, 0.3f, 0.2f};
    model.zones.push_back(zone);
    model::Material material;
    material.zone = 0;
    model.materials.push_back(material);
    return model;
}

}  // namespace

model::Model ball_model(const glm::vec3 &centre)
{
    model::Model model = painted("ball");
    add_node(model, "ball", model::none, centre);
    add_ball(model, 0, glm::vec3(0), 1);
    add_turn(model, 0, 2);
    return model;
}

model::Model swing_model()
{
    model::Model model = painted("swing");
    add_node(model, "shoulder", model::none, glm::vec3(0));
    add_node(model, "arm", 0, glm::vec3(0));
    add_ball(model, 0, glm::vec3(0), 0.1f);
    add_ball(model, 1, {2, 0, 0}, 0.2f);
    add_turn(model, 1, pi);
    return model;
}

}  // namespace actors
