#include "tests/gl/support/jointed.h"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "lib/base/hash.h"

namespace gltest
{
namespace
{

namespace base = claque::base;
namespace math = claque::math;

constexpr uint32_t cells = 3;  // per side

// Six sides of cells x cells quads each.
void add_box(Mesh &mesh, glm::vec3 half, uint32_t part)
{
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
        const float out = side % 2 ? 1.0f : -1.0f;
        glm::vec3 normal(0);
        normal[axis] = out;
        const uint32_t first = static_cast<uint32_t>(mesh.positions.size());
        for (uint32_t y = 0; y <= cells; ++y)
            for (uint32_t x = 0; x <= cells; ++x) {
                const glm::vec2 uv(float(x) / float(cells), float(y) / float(cells));
                glm::vec3 p(0);
                p[axis] = out * half[axis];
                p[u] = (2 * uv.x - 1) * half[u];
                p[v] = (2 * uv.y - 1) * half[v] * out;
                mesh.positions.push_back(p);
                mesh.normals.push_back(normal);
                mesh.uvs.push_back(uv);
            }
        for (uint32_t y = 0; y < cells; ++y)
            for (uint32_t x = 0; x < cells; ++x) {
                const uint32_t a = first + y * (cells + 1) + x, b = a + 1, c = a + cells + 1, d = c + 1;
                mesh.triangles.push_back({a, b, d});
                mesh.triangles.push_back({a, d, c});
                mesh.parts.insert(mesh.parts.end(), {part, part});
                mesh.surfaces.insert(mesh.surfaces.end(), {part % 2, part % 2});
            }
    }
}

void pose(Jointed &out, const std::vector<Joint> &joints)
{
    for (const Joint &joint : joints) {
        math::Trs trs;
        trs.translation = joint.offset;
        trs.rotation = glm::angleAxis(joint.turn_rad, glm::normalize(joint.axis));
        out.locals.push_back(math::affine_of(trs));
        out.globals.push_back(joint.parent == model::none ? out.locals.back()
                                                          : math::mul(out.globals[joint.parent], out.locals.back()));
    }
}

glm::vec3 vertex(const model::Array<float> &numbers, size_t v)
{
    return glm::vec3(numbers[3 * v], numbers[3 * v + 1], numbers[3 * v + 2]);
}

// Source vertices by part; each part follows one palette entry.
void add_rig(model::Template &tmpl, const std::vector<Joint> &joints, const std::vector<uint32_t> &parts,
             const std::vector<uint32_t> &part_of_vertex, float bind_offset)
{
    for (const Joint &joint : joints) {
        tmpl.rig.parents.push_back(joint.parent);
        tmpl.rig.rest.emplace_back();
        tmpl.rig.node_names.emplace_back("node");
    }
    model::Level &level = tmpl.levels[0];
    for (uint32_t part = 0; part < parts.size(); ++part) {
        model::PaletteEntry entry;
        entry.node = parts[part];
        if (bind_offset != 0) {
            math::Trs bind;
            bind.translation = glm::vec3(bind_offset, 0.5f * bind_offset, -bind_offset);
            bind.rotation = glm::angleAxis(bind_offset, glm::vec3(0, 1, 0));
            entry.inverse_bind = math::affine_of(bind);
        }
        tmpl.rig.palette.push_back(entry);
        uint32_t triangles = 0;
        for (const model::Surface &surface : level.surfaces) {
            for (size_t s = 0; s <= surface.clean.size(); ++s) {
                const uint32_t *firsts = surface.part_offsets.data() + s * (parts.size() + 1);
                triangles += (firsts[part + 1] - firsts[part]) / 3;
            }
        }
        level.parts.push_back({parts[part], part, 1, triangles});
        level.part_spheres.push_back({part, {}});
    }
    level.runs.push_back({0, level.source_count, 1, 0});
    for (uint32_t v = 0; v < level.source_count; ++v) {
        level.joints.push_back(static_cast<uint16_t>(part_of_vertex[v]));
        level.weights.push_back(1);
        const math::Affine bind = math::inverse(tmpl.rig.palette[part_of_vertex[v]].inverse_bind);
        const glm::vec3 p = math::transform_point(bind, vertex(level.positions, v));
        const glm::vec3 n = math::transform_vector(bind, vertex(level.normals, v));
        std::copy_n(&p.x, 3, &level.positions[3 * size_t(v)]);
        std::copy_n(&n.x, 3, &level.normals[3 * size_t(v)]);
    }
}

// A sphere round the vertices of each part where they are bound.
void add_spheres(model::Level &level, const std::vector<uint32_t> &part_of_vertex)
{
    for (uint32_t part = 0; part < level.parts.size(); ++part) {
        glm::vec3 low(1e9f), high(-1e9f);
        for (uint32_t v = 0; v < level.source_count; ++v)
            if (part_of_vertex[v] == part)
                low = glm::min(low, vertex(level.positions, v)), high = glm::max(high, vertex(level.positions, v));
        level.part_spheres[part].bind = {0.5f * (low + high), 0.5f * glm::length(high - low)};
    }
}

// Skins: palette matrices first, then vertices.
void place(Jointed &out, const std::vector<uint32_t> &part_of_vertex)
{
    const model::Template &tmpl = *out.posed.tmpl;
    const model::Level &level = tmpl.levels[0];
    for (const model::PaletteEntry &entry : tmpl.rig.palette)
        out.palette.push_back(math::mul(out.globals[entry.node], entry.inverse_bind));
    for (uint32_t v = 0; v < level.vertex_count; ++v) {
        const uint32_t from = v < level.source_count ? v : level.copies[v - level.source_count];
        const math::Affine &matrix = out.palette[part_of_vertex[from]];
        const glm::vec3 p = math::transform_point(matrix, vertex(level.positions, from));
        const glm::vec3 n = math::transform_vector(matrix, vertex(level.normals, from));
        std::copy_n(&p.x, 3, &out.posed.positions[3 * size_t(v)]);
        std::copy_n(&n.x, 3, &out.posed.normals[3 * size_t(v)]);
    }
    measure(out.posed);
}

}  // namespace

Jointed make_jointed(const std::vector<Joint> &joints, const ZoneMap &map, float bind_offset)
{
    Jointed out;
    Mesh mesh;
    std::vector<uint32_t> part_of_vertex;
    for (uint32_t node = 0; node < joints.size(); ++node) {
        if (joints[node].box == glm::vec3(0)) continue;
        add_box(mesh, joints[node].box, static_cast<uint32_t>(out.parts.size()));
        part_of_vertex.resize(mesh.positions.size(), static_cast<uint32_t>(out.parts.size()));
        out.parts.push_back(node);
    }
    mesh.part_count = static_cast<uint32_t>(out.parts.size());
    mesh.surface_count = mesh.part_count > 1 ? 2 : 1;
    out.posed = make_posed(mesh, map);
    add_rig(*out.posed.tmpl, joints, out.parts, part_of_vertex, bind_offset);
    add_spheres(out.posed.tmpl->levels[0], part_of_vertex);
    pose(out, joints);
    place(out, part_of_vertex);
    return out;
}

std::vector<Joint> puppet()
{
    const glm::vec3 limb(0.1f, 0.24f, 0.1f), x(1, 0, 0), z(0, 0, 1), odd(0.3f, 1, 0.5f);
    return {
        {model::none, {0.1f, 0, 0}, 0.2f, {0, 1, 0}, {0, 0, 0}},   // the root, without a box
        {0, {0, 0, 0}, 0.1f, z, {0.3f, 0.2f, 0.2f}},               // pelvis
        {1, {0, 0.5f, 0}, -0.2f, odd, {0.35f, 0.26f, 0.2f}},       // chest
        {2, {0, 0.34f, 0}, 0.3f, z, {0, 0, 0}},                    // neck, without a box
        {3, {0, 0.22f, 0}, 0.25f, odd, {0.18f, 0.18f, 0.18f}},     // head
        {2, {-0.6f, 0.1f, 0}, -0.8f, z, limb},                     // arms
        {5, {0, -0.55f, 0}, -0.5f, x, limb},                       //
        {2, {0.6f, 0.1f, 0}, 0.9f, z, limb},                       //
        {7, {0, -0.55f, 0}, -0.7f, x, {0.09f, 0.2f, 0.12f}},       //
        {1, {-0.25f, -0.5f, 0}, -0.2f, z, limb},                   // legs
        {9, {-0.05f, -0.55f, 0}, 0.3f, x, {0.11f, 0.25f, 0.11f}},  //
        {1, {0.25f, -0.5f, 0}, 0.25f, z, limb},                    //
        {11, {0.05f, -0.55f, 0}, 0.45f, {1, 0, 0.2f}, {0.1f, 0.26f, 0.12f}},
    };
}

std::vector<Joint> rope(uint32_t count)
{
    std::vector<Joint> joints;
    for (uint32_t i = 0; i < count; ++i) {
        const float turn = 0.4f * base::unit(base::hash(3, i, base::Purpose::pick)) - 0.15f;
        joints.push_back(
            {i == 0 ? model::none : i - 1, {0, i == 0 ? 0.0f : 0.1f, 0}, turn, {0.2f, 0.1f, 1}, {0.03f, 0.04f, 0.03f}});
    }
    return joints;
}

claque::draw::DrawList by_matrices(const Jointed &jointed, const Camera &camera, const uint8_t *zone_rgb)
{
    claque::draw::DrawList list = list_of(jointed.posed, camera, zone_rgb);
    list.items[0].locals = jointed.locals.data();
    list.items[0].vertices = {};
    return list;
}

Camera hashed_camera(const PosedModel &posed, uint32_t index, float aspect)
{
    const auto draw = [&](uint32_t k) { return base::unit(base::hash(11, index, base::Purpose::pick, k)); };
    const float r = posed.radius, distance = r * (0.3f + 2.5f * draw(0) * draw(0));
    glm::mat4 view = glm::translate(glm::mat4(1), glm::vec3((draw(1) - 0.5f) * r, (draw(2) - 0.5f) * r, -distance));
    view = glm::rotate(view, 1.2f * (draw(3) - 0.5f), glm::vec3(1, 0, 0));
    view = glm::rotate(view, 6.3f * draw(4), glm::vec3(0, 1, 0));
    view = glm::translate(view, -posed.centre);
    const glm::mat4 projection = glm::perspective(0.8f, aspect, 0.05f * r, distance + r * (0.2f + draw(5)));
    Camera camera;
    std::copy_n(glm::value_ptr(projection), 16, camera.projection);
    std::copy_n(glm::value_ptr(view), 16, camera.model_view);
    return camera;
}

}  // namespace gltest
