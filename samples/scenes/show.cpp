#include "samples/scenes/show.h"

#include <cmath>
#include <cstdint>

#include "samples/scenes/check.h"

namespace scenes
{

namespace
{

constexpr unsigned lines = 1;
constexpr int spokes = 48;  // of a circle

struct Point {
    float x, y, z;
};

// Three circles round the axes of a sphere of radius 1.
struct Wires {
    Wires()
    {
        for (int axis = 0; axis < 3; ++axis)
            for (int k = 0; k < spokes; ++k) {
                const double angle = 2 * 3.14159265358979323846 * k / spokes;
                const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
                points.push_back(axis == 0 ? Point{0, c, s} : axis == 1 ? Point{c, 0, s} : Point{c, s, 0});
                indices.push_back(static_cast<uint32_t>(axis * spokes + k));
                indices.push_back(static_cast<uint32_t>(axis * spokes + (k + 1) % spokes));
            }
    }
    std::vector<Point> points;
    std::vector<uint32_t> indices;
};

void begin_lines(const Gl &g, const float *projection)
{
    g.MatrixMode(gl::projection);
    if (projection) g.LoadMatrixf(projection);
    else g.LoadIdentity();
    g.Disable(gl::lighting);
    g.Disable(gl::texture_2d);
    g.Disable(gl::cull_face);
    g.Enable(gl::blend);
    g.BlendFunc(gl::src_alpha, gl::one_minus_src_alpha);
    g.EnableClientState(gl::vertex_array);
    g.MatrixMode(gl::modelview);
}

void end_lines(const Gl &g)
{
    g.DisableClientState(gl::vertex_array);
    g.Disable(gl::blend);
    g.Color4f(1, 1, 1, 1);
}

void draw_sphere(const Gl &g, const Eye &eye, const Wires &wires, const double (&at)[3], double radius)
{
    float matrix[16];
    for (int i = 0; i < 16; ++i) matrix[i] = eye.rotation[i] * (i < 12 ? static_cast<float>(radius) : 1.0f);
    for (int r = 0; r < 3; ++r) {
        double sum = 0;
        for (int c = 0; c < 3; ++c) sum += static_cast<double>(eye.rotation[4 * c + r]) * (at[c] - eye.position[c]);
        matrix[12 + r] = static_cast<float>(sum);
    }
    matrix[15] = 1;
    g.LoadMatrixf(matrix);
    g.VertexPointer(3, gl::float_type, 0, wires.points.data());
    g.DrawElements(lines, static_cast<int>(wires.indices.size()), gl::unsigned_int, wires.indices.data());
}

// `offset` scaled, rotated and translated by a transform.
void put(const clq_transform &place, const float (&offset)[3], double (&out)[3])
{
    const double x = static_cast<double>(place.orientation_xyzw[0]), y = static_cast<double>(place.orientation_xyzw[1]);
    const double z = static_cast<double>(place.orientation_xyzw[2]), w = static_cast<double>(place.orientation_xyzw[3]);
    const double v[3] = {static_cast<double>(offset[0]), static_cast<double>(offset[1]),
                         static_cast<double>(offset[2])};
    const double t[3] = {2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])};
    const double turned[3] = {v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
                              v[2] + w * t[2] + x * t[1] - y * t[0]};
    for (int k = 0; k < 3; ++k) out[k] = place.position[k] + static_cast<double>(place.scale) * turned[k];
}

}  // namespace

void draw_spheres(const Gl &g, const Eye &eye, clq_crowd *crowd, const std::vector<clq_actor> &actors)
{
    const Wires wires;
    begin_lines(g, eye.projection);
    for (const clq_actor actor : actors) {
        clq_actor_info info = clq_actor_info_init();
        check(clq_actor_get_info(crowd, actor, &info));
        clq_template_info tmpl = clq_template_info_init();
        check(clq_template_get_info(info.tmpl, &tmpl));
        const float alpha = info.visible ? 1.0f : 0.35f;
        const double scale = std::fabs(static_cast<double>(info.root.scale));
        double centre[3];
        put(info.root, tmpl.sklsroot_centre, centre);
        g.Color4f(0.90f, 0.45f, 0.05f, alpha);
        draw_sphere(g, eye, wires, centre, scale * static_cast<double>(info.sklsroot_radius));
        // A member's transform is in its group's space.
        if (info.group.index1 != 0) continue;
        g.Color4f(0.10f, 0.30f, 0.80f, alpha);
        draw_sphere(g, eye, wires, info.transform.position, scale * static_cast<double>(info.refpoint_radius));
    }
    end_lines(g);
}

void tint_by_level(clq_crowd *crowd, const std::vector<clq_actor> &actors)
{
    constexpr float tints[7][3] = {{0.20f, 0.65f, 0.25f}, {0.90f, 0.85f, 0.15f}, {0.95f, 0.55f, 0.10f},
                                   {0.85f, 0.15f, 0.15f}, {0.60f, 0.25f, 0.70f}, {0.20f, 0.40f, 0.85f},
                                   {0.45f, 0.45f, 0.45f}};
    std::vector<float> rgb;
    for (const clq_actor actor : actors) {
        clq_actor_info info = clq_actor_info_init();
        check(clq_actor_get_info(crowd, actor, &info));
        if (!info.visible) continue;
        clq_template_info tmpl = clq_template_info_init();
        check(clq_template_get_info(info.tmpl, &tmpl));
        const float *tint = tints[info.level < 7 ? info.level : 6];
        rgb.clear();
        for (uint32_t zone = 0; zone < tmpl.zone_count; ++zone) rgb.insert(rgb.end(), tint, tint + 3);
        check(clq_actor_set_colours(crowd, actor, rgb.data(), tmpl.zone_count));
    }
}

void draw_frustum(const Gl &g, float share)
{
    const Point corners[4] = {{-share, -share, 0}, {share, -share, 0}, {share, share, 0}, {-share, share, 0}};
    const uint32_t edges[8] = {0, 1, 1, 2, 2, 3, 3, 0};
    begin_lines(g, nullptr);
    g.Disable(gl::depth_test);
    g.LoadIdentity();
    g.Color4f(1, 0.9f, 0.1f, 1);
    g.VertexPointer(3, gl::float_type, 0, corners);
    g.DrawElements(lines, 8, gl::unsigned_int, edges);
    g.Enable(gl::depth_test);
    end_lines(g);
}

}  // namespace scenes
