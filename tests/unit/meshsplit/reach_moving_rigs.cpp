#include <cmath>

#include <glm/geometric.hpp>

#include "reach_rigs.h"

namespace claque::test
{

using model::DofKind;

namespace
{

model::Model bare_moving(const char *name)
{
    model::Model m;
    m.name = name;
    return m;
}

void add_clip(model::Model &m, float length_s, uint32_t channels)
{
    m.rig.clips.push_back({static_cast<uint32_t>(m.rig.channels.size()), channels, 0, length_s});
    m.rig.clip_names.emplace_back(m.name);
}

// A face that a clip and its degrees of freedom pull out, on a neck that turns.
FreeModel morphing()
{
    model::Model m = bare_moving("morphing");
    const uint32_t point_set = add_node(m, model::none, {0, 0, 0}, "body"),
                   head = add_node(m, point_set, {0, 1, 0}, "head");
    add_box(m, point_set, {0, 0.4f, 0}, {0.3f, 0.5f, 0.2f});
    add_box(m, head, {0, 0.2f, 0}, {0.2f, 0.2f, 0.2f});
    model::Part &face = m.parts.back();
    m.rig.morph_sets.push_back({head, 0, 2});
    m.rig.rest_weights = {0.1f, 0};
    face.morph_set = 0;
    face.morphs.resize(2);
    for (const glm::vec3 &p : face.positions) {
        face.morphs[0].positions.push_back(glm::vec3(0, 0.5f, 0) * (p.y > 0.2f ? 1.0f : 0.1f));
        face.morphs[1].positions.push_back(glm::vec3(0.2f, 0, 0.8f) * p.z);
    }
    add_clip(m, 1, 1);
    m.rig.times = {0, 1};
    m.rig.values = {0, 0.5f, 1.2f, -0.5f};
    m.rig.channels.push_back({0, model::ChannelTarget::morph_weights, model::Interpolation::linear, 2, 0, 2, 0});
    add_dof(m, 0, DofKind::morph, {0, 1, 0}, -0.3f, 0.8f);
    m.rig.dofs.back().morph_target = 0;
    add_dof(m, 0, DofKind::morph, {0, 1, 0}, 0, 1);
    m.rig.dofs.back().morph_target = 1;
    add_dof(m, head, DofKind::rotation, {1, 0, 0}, -0.6f, 0.4f);
    return {"morphing", std::move(m)};
}

// A turntable that a clip rotates fully within a frame; objects on it lean by degrees of freedom.
FreeModel whirl()
{
    model::Model m = bare_moving("whirl");
    const uint32_t table = add_node(m, model::none, {0, 0, 0}, "table"), mast = add_node(m, table, {1, 0, 0}, "mast");
    const uint32_t still = add_node(m, model::none, {-2, -2, 0}, "still");
    add_box(m, table, {0, 0, 0}, {1, 0.1f, 1});
    add_box(m, mast, {0, 0.7f, 0}, {0.1f, 0.7f, 0.1f});
    add_box(m, still, {0, 0, 0}, {0.3f, 0.3f, 0.3f});
    add_dof(m, mast, DofKind::rotation, {0, 0, 1}, -0.4f, 0.9f);
    add_clip(m, 0.5f, 2);
    const float h = std::sqrt(0.75f);
    m.rig.times = {0, 1 / 60.0f, 0.5f};
    m.rig.values = {0, 0, 0, 1, 0, h, 0, 0.5f, 0, 0.2f, 0, 0.9798f, 1, 0, 0, 1.5f, 0, 0, 0.8f, 0.5f, 0};
    m.rig.channels.push_back({table, model::ChannelTarget::rotation, model::Interpolation::linear, 4, 0, 3, 0});
    m.rig.channels.push_back({mast, model::ChannelTarget::translation, model::Interpolation::linear, 3, 0, 3, 12});
    return {"whirl", std::move(m)};
}

// Cubic splines with keys only two frames apart, which overshoot far.
FreeModel overshoot()
{
    model::Model m = bare_moving("overshoot");
    const uint32_t base = add_node(m, model::none, {0, 0, 0}, "base"), arm = add_node(m, base, {0, 1, 0}, "arm");
    add_box(m, base, {0, 0.5f, 0}, {0.2f, 0.5f, 0.2f});
    add_box(m, arm, {0, 0.5f, 0}, {0.1f, 0.5f, 0.1f});
    add_dof(m, arm, DofKind::rotation, {0, 0, 1}, -1.5f, 0.2f);
    add_clip(m, 1 / 60.0f, 2);
    m.rig.times = {0, 1 / 60.0f};
    m.rig.values = {0, 0, 0, 0, 1, 0, 0, 240, 0, 0, -240, 0, 0, 1, 0, 0, 0, 0};
    m.rig.values.insert(m.rig.values.end(),
                        {0, 0, 0, 0, 0, 0, 0, 1, 200, 0, 0, 0, 0, 0, 0, 0, 0.6f, 0, 0, 0.8f, 0, 0, 0, 0});
    m.rig.channels.push_back({arm, model::ChannelTarget::translation, model::Interpolation::cubic_spline, 3, 0, 2, 0});
    m.rig.channels.push_back({arm, model::ChannelTarget::rotation, model::Interpolation::cubic_spline, 4, 0, 2, 18});
    return {"overshoot", std::move(m)};
}

// Two arms that a clip pushes in and turns outwards. Where their spheres reach farthest the arms point to the centre;
// they are farthest where the spheres are smaller, and only with degrees of freedom at an end.
FreeModel fold()
{
    model::Model m = bare_moving("fold");
    const float s = std::sin(0.6f), c = std::cos(0.6f);
    m.rig.times = {0, 1};
    m.rig.values = {0, 0, 1, 0, 0, 0, -s, c, 0, 0, 0, 1, 0, 0, c, s, 1.1f, 0, 0, 0.9f, 0, 0, -1.1f, 0, 0, -0.9f, 0, 0};
    add_clip(m, 1, 4);
    for (uint32_t i = 0; i < 2; ++i) {
        const uint32_t arm = add_node(m, model::none, {i ? -0.9f : 0.9f, 0, 0}, "arm");
        m.rig.rest[arm].rotation = i ? glm::quat(s, 0, 0, c) : glm::quat(c, 0, 0, -s);
        add_box(m, arm, {1, 0, 0}, {0.1f, 0.1f, 0.1f});
        add_dof(m, arm, DofKind::rotation, {0, 0, 1}, 0, 1.2f);
        m.rig.channels.push_back({arm, model::ChannelTarget::rotation, model::Interpolation::linear, 4, 0, 2, 8 * i});
        m.rig.channels.push_back(
            {arm, model::ChannelTarget::translation, model::Interpolation::linear, 3, 0, 2, 16 + 6 * i});
    }
    return {"fold", std::move(m)};
}

// Two tips that are farthest from the centre, and from each other, half way between two frames.
FreeModel pass()
{
    model::Model m = bare_moving("pass");
    const float s = std::sin(0.032f), c = std::cos(0.032f);
    m.rig.times = {0, 1 / 60.0f};
    m.rig.values = {0, 0, -s, c, 0, 0, s, c};
    add_clip(m, 1 / 60.0f, 2);
    for (const float side : {1.0f, -1.0f}) {
        const uint32_t arm = add_node(m, model::none, {2 * side, 0, 0}, "arm");
        m.rig.rest[arm].rotation = glm::quat(c, 0, 0, -s);
        const uint32_t tip = add_node(m, arm, {side, 0, 0}, "tip");
        add_box(m, tip, {0, 0, 0}, {0.0001f, 0.0001f, 0.0001f});
        add_dof(m, tip, DofKind::translation, {0, 0, 1}, 0, 0.0001f);
        m.rig.channels.push_back({arm, model::ChannelTarget::rotation, model::Interpolation::linear, 4, 0, 2, 0});
    }
    return {"pass", std::move(m)};
}

}  // namespace

std::vector<FreeModel> moving_models()
{
    std::vector<FreeModel> out;
    out.push_back(morphing());
    out.push_back(whirl());
    out.push_back(overshoot());
    out.push_back(fold());
    out.push_back(pass());
    return out;
}

}  // namespace claque::test
