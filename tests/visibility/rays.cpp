#include "tests/visibility/rays.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/check.h"

namespace visibility_test
{

using scenes::check;

namespace
{

struct Flat {
    double x, y, w, depth;  // pixels, 1 / w is linear in them; window depth
};

Flat flat_of(const clq_camera &camera, int width, int height, const Point &e)
{
    double clip[4];
    for (size_t k = 0; k < 4; ++k) {
        clip[k] = static_cast<double>(camera.projection[12 + k]);
        for (size_t i = 0; i < 3; ++i) clip[k] += static_cast<double>(camera.projection[4 * i + k]) * e[i];
    }
    return {(clip[0] / clip[3] + 1) * width / 2, (clip[1] / clip[3] + 1) * height / 2, clip[3],
            (clip[2] / clip[3] + 1) / 2};
}

double twice_area(const Flat &a, const Flat &b, double x, double y)
{
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

double distance_px(const Flat &a, const Flat &b, double x, double y)
{
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double along = square > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / square, 0.0, 1.0) : 0;
    return std::hypot(x - a.x - along * dx, y - a.y - along * dy);
}

}  // namespace

std::array<double, 2> pixel_of(const clq_camera &camera, int width, int height, const Point &eye)
{
    const Flat flat = flat_of(camera, width, height, eye);
    return {flat.x, flat.y};
}

std::vector<Body> bodies_of(const clq_view *view)
{
    clq_view_stats stats = clq_view_stats_init();
    check(clq_view_get_stats(view, &stats));
    std::vector<Body> all(stats.visible);
    for (uint32_t i = 0; i < stats.visible; ++i) {
        Body &body = all[i];
        check(clq_view_get_drawn_actor(view, i, &body.drawn));
        std::vector<float> xyz(3 * static_cast<size_t>(body.drawn.vertex_count));
        check(clq_view_get_vertices(view, i, xyz.data(), nullptr, body.drawn.vertex_count));
        clq_mesh mesh = clq_mesh_init();
        check(clq_template_get_mesh(body.drawn.tmpl, body.drawn.level, &mesh));
        for (uint32_t bin = 0; bin < mesh.bin_count; ++bin) {
            clq_triangles triangles = clq_triangles_init();
            check(clq_template_get_triangles(body.drawn.tmpl, body.drawn.level, bin, &triangles));
            for (uint32_t k = 0; k < triangles.index_count; k += 3) {
                Body::Triangle &made = body.triangles.emplace_back();
                made.zone = triangles.zone, made.double_sided = triangles.double_sided;
                for (size_t c = 0; c < 3; ++c) {
                    made.corners[c] = triangles.indices[k + c];
                    const float *p = &xyz[3 * static_cast<size_t>(made.corners[c])];
                    const float *m = body.drawn.model_view;
                    for (size_t r = 0; r < 3; ++r) {
                        made.eye[c][r] = static_cast<double>(m[12 + r]);
                        for (size_t j = 0; j < 3; ++j)
                            made.eye[c][r] += static_cast<double>(m[4 * j + r]) * static_cast<double>(p[j]);
                    }
                }
            }
        }
    }
    return all;
}

Hit hit_at(const std::vector<Body> &bodies, const clq_camera &camera, int width, int height, int px, int py)
{
    const double x = px + 0.5, y = py + 0.5;
    Hit best;
    std::vector<std::pair<double, double>> near;  // depth, pixels from an edge: triangles that are or could be here
    for (uint32_t b = 0; b < bodies.size(); ++b)
        for (uint32_t t = 0; t < bodies[b].triangles.size(); ++t) {
            const Body::Triangle &triangle = bodies[b].triangles[t];
            Flat f[3];
            for (size_t k = 0; k < 3; ++k) f[k] = flat_of(camera, width, height, triangle.eye[k]);
            const double area = twice_area(f[0], f[1], f[2].x, f[2].y);
            if (area == 0) continue;
            const bool front = (area > 0) != bodies[b].drawn.mirrored;
            if (!front && !triangle.double_sided) continue;
            const double in[3] = {twice_area(f[1], f[2], x, y) / area, twice_area(f[2], f[0], x, y) / area,
                                  twice_area(f[0], f[1], x, y) / area};
            const double depth = in[0] * f[0].depth + in[1] * f[1].depth + in[2] * f[2].depth;
            const bool inside = in[0] >= 0 && in[1] >= 0 && in[2] >= 0;
            const double edge =
                std::min({distance_px(f[0], f[1], x, y), distance_px(f[1], f[2], x, y), distance_px(f[2], f[0], x, y)});
            if (!inside && edge > 0.02) continue;
            near.emplace_back(depth, edge);
            if (!inside || depth > best.window_depth || depth < 0) continue;
            const double sum = in[0] / f[0].w + in[1] / f[1].w + in[2] / f[2].w;
            best.body = b, best.triangle = t, best.window_depth = depth;
            best.eye = {0, 0, 0};
            for (size_t k = 0; k < 3; ++k) {
                best.weights[k] = in[k] / f[k].w / sum;
                for (size_t j = 0; j < 3; ++j) best.eye[j] += best.weights[k] * triangle.eye[k][j];
            }
        }
    bool self = false;
    for (const auto &[depth, edge] : near) {
        if (depth <= best.window_depth + 1e-6) best.edge_px = std::min(best.edge_px, edge);
        if (!self && depth == best.window_depth) self = true;
        else best.step = std::min(best.step, std::fabs(depth - best.window_depth));
    }
    return best;
}

}  // namespace visibility_test
