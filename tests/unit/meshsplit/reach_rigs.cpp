#include "reach_rigs.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "lib/base/hash.h"

namespace claque::test
{

using model::DofKind;

namespace
{

float rig_random(uint32_t seed, uint32_t i) { return base::unit(base::hash(seed, i, base::Purpose::pick)); }

glm::vec3 any_axis(uint32_t seed, uint32_t i)
{
    return glm::normalize(glm::vec3(rig_random(seed, 3 * i), rig_random(seed, 3 * i + 1), rig_random(seed, 3 * i + 2)) -
                          0.4f);
}

model::Model bare(const char *name)
{
    model::Model m;
    m.name = name;
    return m;
}

// Links of a metre, each with a rotation about an axis of its own.
FreeModel chain(const char *name, float widest)
{
    model::Model m = bare(name);
    for (uint32_t i = 0; i < 8; ++i) {
        const uint32_t node = add_node(m, i == 0 ? model::none : i - 1, {0, i == 0 ? 0 : 1, 0}, "link");
        add_dof(m, node, DofKind::rotation, any_axis(7, i), -widest * rig_random(8, i), widest * rig_random(9, i));
        add_box(m, node, {0, 0.5f, 0}, {0.1f, 0.5f, 0.2f});
    }
    return {name, std::move(m)};
}

FreeModel slides()
{
    model::Model m = bare("slides");
    const uint32_t base = add_node(m, model::none, {0, 0, 0}, "base");
    const uint32_t carriage = add_node(m, base, {1, 0, 0}, "carriage"), head = add_node(m, carriage, {0, 1, 0}, "head");
    m.rig.rest[carriage].rotation = glm::normalize(glm::quat(0.8f, 0.1f, 0.5f, -0.2f));
    add_box(m, base, {0, 0, 0}, {1, 0.2f, 0.3f});
    add_box(m, carriage, {0, 0, 0}, {0.2f, 0.3f, 0.4f});
    add_box(m, head, {0, 0.2f, 0}, {0.5f, 0.1f, 0.1f});
    add_dof(m, carriage, DofKind::translation, {1, 0, 0}, -2, 1);
    add_dof(m, carriage, DofKind::rotation, {0, 0, 1}, -0.5f, 1.1f);
    add_dof(m, carriage, DofKind::translation, glm::normalize(glm::vec3(1, 1, 0)), 0.5f, 1.5f);
    add_dof(m, head, DofKind::translation, {0, 1, 0}, 0, 0.7f);
    add_dof(m, head, DofKind::rotation, {0, 1, 0}, -3.1f, 3.1f);
    return {"slides", std::move(m)};
}

FreeModel scaled_and_mirrored()
{
    model::Model m = bare("scaled and mirrored");
    const uint32_t file = add_node(m, model::none, {0, 0, 0}, "file");
    m.rig.rest[file].scale = glm::vec3(0.01f);
    const uint32_t point_set = add_node(m, file, {20, 80, 0}, "body"), arm = add_node(m, point_set, {40, 30, 0}, "arm");
    m.rig.rest[point_set].scale = glm::vec3(1, 2, 0.5f);
    m.rig.rest[arm].scale = glm::vec3(-1, 1, 1.5f);
    m.rig.rest[arm].rotation = glm::normalize(glm::quat(0.9f, 0.2f, -0.3f, 0.1f));
    const uint32_t hand = add_node(m, arm, {50, 0, 10}, "hand");
    add_box(m, point_set, {0, 0, 0}, {30, 40, 20});
    add_box(m, arm, {25, 0, 0}, {25, 8, 8});
    add_box(m, hand, {10, 0, 0}, {12, 6, 3});
    add_dof(m, point_set, DofKind::rotation, {0, 1, 0}, -1, 0.5f);
    add_dof(m, arm, DofKind::rotation, {0, 0, 1}, -2, 1.2f);
    add_dof(m, arm, DofKind::rotation, {0, 1, 0}, -0.7f, 0.9f);
    add_dof(m, hand, DofKind::rotation, {1, 0, 0}, -1.5f, 1.5f);
    return {"scaled and mirrored", std::move(m)};
}

// One skin over four joints.
FreeModel worm()
{
    model::Model m = bare("worm");
    for (uint32_t i = 0; i < 4; ++i) {
        add_node(m, i == 0 ? model::none : i - 1, {i == 0 ? 0 : 1, 0, 0}, "joint");
        math::Affine back;
        back.set_column(3, glm::vec3(-float(i), 0, 0));
        m.rig.palette.push_back({i, back});
        add_dof(m, i, DofKind::rotation, i % 2 ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1), -0.8f, 0.6f);
    }
    model::Part skin = sheet_part(16, 2);
    skin.material = model::none;
    skin.influence_count = 2;
    skin.joints.clear(), skin.weights.clear();
    for (glm::vec3 &p : skin.positions) {
        p = glm::vec3(4 * p.x, 0.5f * p.y - 0.25f, 0);
        const uint32_t joint = std::min(uint32_t(p.x), 3u);
        const float f = p.x < 3 ? std::max(0.0f, p.x - float(joint) - 0.5f) : 0.3f;
        skin.joints.insert(skin.joints.end(), {joint, joint < 3 ? joint + 1 : 2});
        skin.weights.insert(skin.weights.end(), {1 - f, f});
    }
    m.parts.push_back(skin);
    return {"worm", std::move(m)};
}

// A static spiky shape whose longest spike is not among those along axes and diagonals, beside a moving part.
FreeModel burr()
{
    model::Model m = bare("burr");
    const uint32_t base = add_node(m, model::none, {0, 0, 0}, "base"), eye = add_node(m, base, {0.5f, 0, 0}, "eye");
    for (int i = 0; i < 27; ++i) {
        const glm::vec3 way(float(i % 3 - 1), float(i / 3 % 3 - 1), float(i / 9 - 1));
        if (i != 13) add_box(m, base, glm::normalize(way), glm::vec3(0.001f));
    }
    add_box(m, base, 1.08f * glm::normalize(glm::vec3(1, 0.414f, 0.318f)), glm::vec3(0.001f));
    add_box(m, eye, {0, 0, 0}, {0.1f, 0.1f, 0.1f});
    add_dof(m, eye, DofKind::rotation, {0, 1, 0}, -1, 1);
    return {"burr", std::move(m)};
}

// The coarse level's box is the larger one.
FreeModel levels()
{
    model::Model m = bare("levels");
    const uint32_t base = add_node(m, model::none, {0, 0, 0}, "base"), arm = add_node(m, base, {0, 1, 0}, "arm");
    add_box(m, base, {0, 0.5f, 0}, {0.2f, 0.5f, 0.2f});
    add_box(m, arm, {0, 0.5f, 0}, {0.1f, 0.5f, 0.1f});
    m.parts.back().lod_max_m = 20;
    add_box(m, arm, {0, 0.6f, 0}, {0.2f, 0.7f, 0.2f});
    m.parts.back().lod_min_m = 20;
    add_dof(m, arm, DofKind::rotation, {0, 0, 1}, -1.5f, 0.2f);
    return {"levels", std::move(m)};
}

}  // namespace

void add_dof(model::Model &m, uint32_t node, DofKind kind, glm::vec3 axis, float first, float last)
{
    model::Dof dof;
    dof.node = node, dof.kind = kind, dof.axis = axis;
    dof.min = first, dof.max = last;
    dof.rest = std::min(std::max(0.0f, first), last);
    m.rig.dofs.push_back(dof);
    m.rig.dof_names.emplace_back(std::to_string(m.rig.dofs.size()));
}

uint32_t add_node(model::Model &m, uint32_t parent, glm::vec3 at, const char *name)
{
    m.rig.parents.push_back(parent);
    m.rig.rest.emplace_back();
    m.rig.rest.back().translation = at;
    m.rig.node_names.emplace_back(name);
    return m.rig.node_count() - 1;
}

void add_box(model::Model &m, uint32_t node, glm::vec3 centre, glm::vec3 half)
{
    model::Part part;
    part.name = "box";
    part.node = node;
    for (uint32_t side = 0; side < 6; ++side) {
        const int k = int(side / 2);
        const float sign = side % 2 ? -1.0f : 1.0f;
        for (int corner = 0; corner < 4; ++corner) {
            glm::vec3 p(0), n(0);
            n[k] = p[k] = sign;
            p[(k + 1) % 3] = (corner == 1 || corner == 2) ? 1.0f : -1.0f;
            p[(k + 2) % 3] = sign * (corner >= 2 ? 1.0f : -1.0f);
            part.positions.push_back(centre + half * p);
            part.normals.push_back(n);
        }
        for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) part.indices.push_back(4 * side + i);
    }
    part.joints.assign(part.positions.size(), static_cast<uint32_t>(m.rig.palette.size()));
    part.weights.assign(part.positions.size(), 1);
    m.rig.palette.push_back({node, math::Affine()});
    m.parts.push_back(part);
}

FreeModel articulated_actor()
{
    model::Model m = bare("articulated actor");
    const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const auto turn = [&](uint32_t node, glm::vec3 axis, float first, float last) {
        add_dof(m, node, DofKind::rotation, axis, first, last);
    };
    const uint32_t pelvis = add_node(m, model::none, {0, 1, 0}, "pelvis");
    const uint32_t chest = add_node(m, pelvis, {0, 0.15f, 0}, "chest"), neck = add_node(m, chest, {0, 0.4f, 0}, "neck");
    const uint32_t head = add_node(m, neck, {0, 0.1f, 0}, "head");
    add_box(m, pelvis, {0, 0, 0}, {0.18f, 0.12f, 0.12f});
    add_box(m, chest, {0, 0.2f, 0}, {0.2f, 0.2f, 0.13f});
    add_box(m, neck, {0, 0.05f, 0}, {0.05f, 0.06f, 0.05f});
    add_box(m, head, {0, 0.13f, 0.02f}, {0.09f, 0.13f, 0.11f});
    turn(chest, y, -0.6f, 0.6f), turn(chest, x, -0.3f, 0.9f), turn(neck, y, -0.8f, 0.8f), turn(head, x, -0.5f, 0.5f);
    turn(head, z, -0.4f, 0.4f);
    for (const float side : {1.0f, -1.0f}) {
        const uint32_t arm = add_node(m, chest, {side * 0.22f, 0.36f, 0}, "upper arm");
        const uint32_t forearm = add_node(m, arm, {0, -0.3f, 0}, "forearm");
        const uint32_t hand = side > 0 ? add_node(m, forearm, {0, -0.26f, 0}, "hand") : model::none;
        const uint32_t thigh = add_node(m, pelvis, {side * 0.1f, -0.08f, 0}, "thigh");
        const uint32_t shin = add_node(m, thigh, {0, -0.44f, 0}, "shin");
        add_box(m, arm, {0, -0.15f, 0}, {0.05f, 0.16f, 0.05f});
        add_box(m, forearm, {0, -0.13f, 0}, {0.04f, 0.14f, 0.04f});
        add_box(m, thigh, {0, -0.22f, 0}, {0.07f, 0.23f, 0.08f});
        add_box(m, shin, {0, -0.24f, 0.02f}, {0.05f, 0.25f, 0.09f});
        turn(arm, x, -2.8f, 0.8f), turn(arm, z, side > 0 ? -0.2f : -2.5f, side > 0 ? 2.5f : 0.2f);
        turn(forearm, x, -2.4f, 0), turn(thigh, x, -1.6f, 0.5f), turn(thigh, z, -0.5f, 0.5f), turn(shin, x, 0, 2.2f);
        if (hand == model::none) continue;
        add_box(m, hand, {0, -0.08f, 0}, {0.02f, 0.09f, 0.05f});
        turn(hand, z, -1, 1), turn(hand, y, -1, 1);
    }
    return {"articulated actor", std::move(m)};
}

std::vector<FreeModel> free_models()
{
    std::vector<FreeModel> out;
    out.push_back(articulated_actor());
    out.push_back(chain("chain of small turns", 0.6f));
    out.push_back(chain("chain of wide turns", 3.1f));
    out.push_back(slides());
    out.push_back(scaled_and_mirrored());
    out.push_back(worm());
    out.push_back(burr());
    out.push_back(levels());
    for (FreeModel &moving : moving_models()) out.push_back(std::move(moving));
    return out;
}

}  // namespace claque::test
