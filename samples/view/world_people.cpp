// Single individuals of a world: found, picked, tinted and told what to do.
#include <claque/mesh.h>

#include <algorithm>
#include <cmath>

#include "samples/view/world.h"

namespace view
{
namespace
{

struct Rgb3 {
    float r, g, b;
};

// From green over yellow and red to violet.
Rgb3 heat(double share)
{
    static const Rgb3 steps[] = {{0.20f, 0.65f, 0.25f},
                                 {0.90f, 0.85f, 0.15f},
                                 {0.95f, 0.55f, 0.10f},
                                 {0.85f, 0.15f, 0.15f},
                                 {0.60f, 0.25f, 0.70f}};
    const double at = std::clamp(share, 0.0, 1.0) * 4;
    const size_t first = std::min<size_t>(3, static_cast<size_t>(at));
    const float t = static_cast<float>(at - static_cast<double>(first));
    const Rgb3 &a = steps[first], &b = steps[first + 1];
    return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t};
}

// The share of a level's triangles that show several zones.
double dirty_share(const clq_template *tmpl, uint32_t level)
{
    clq_mesh mesh = clq_mesh_init();
    scenes::check(clq_template_get_mesh(tmpl, level, &mesh));
    double dirty = 0, all = 0;
    for (uint32_t bin = 0; bin < mesh.bin_count; ++bin) {
        clq_triangles triangles = clq_triangles_init();
        scenes::check(clq_template_get_triangles(tmpl, level, bin, &triangles));
        all += triangles.index_count;
        if (triangles.zone == CLQ_NONE) dirty += triangles.index_count;
    }
    return all > 0 ? dirty / all : 0;
}

Rgb3 tint_of(Tint tint, const clq_actor_info &info, double time_s)
{
    if (tint == Tint::zones) return heat(2 * dirty_share(info.tmpl, info.level));
    if (tint == Tint::level) return heat(info.level / 6.0);
    // Rates from 50 to 4 a second, ages up to a quarter of a second.
    if (tint == Tint::rate) return heat((static_cast<double>(info.period_s) - 0.02) / 0.23);
    return heat((time_s - info.tick_s) / 0.25);
}

}  // namespace

bool World::find(clq_actor actor, clq_actor_info &out) const
{
    return actor.index1 != 0 && clq_actor_get_info(scene_->crowd(), actor, &out) == CLQ_OK;
}

std::vector<clq_actor> World::everyone() const
{
    std::vector<clq_actor> actors(clq_crowd_get_actor_count(scene_->crowd()));
    uint32_t count = 0;
    scenes::check(clq_scene_find(index_, nullptr, actors.data(), static_cast<uint32_t>(actors.size()), &count));
    actors.resize(std::min<size_t>(actors.size(), count));
    return actors;
}

Picked World::pick(float x, float y) const
{
    clq_ray ray = {};
    clq_scene_pick met = clq_scene_pick_init();
    scenes::check(clq_camera_get_ray(&camera_, x, y, &ray));
    scenes::check(clq_scene_pick_triangle(index_, view_.get(), &ray, nullptr, &met));
    if (met.actor.index1 == 0) return {};
    return {met.actor, met.zone};
}

bool World::drawn(clq_actor actor, uint32_t &index, clq_drawn_actor &out) const
{
    clq_view_stats seen = clq_view_stats_init();
    scenes::check(clq_view_get_stats(view_.get(), &seen));
    for (index = 0; index < seen.visible; ++index) {
        scenes::check(clq_view_get_drawn_actor(view_.get(), index, &out));
        if (out.actor.index1 == actor.index1 && !out.shadow_only) return true;
    }
    return false;
}

std::vector<uint8_t> World::colours(clq_actor actor) const
{
    uint32_t index = 0;
    clq_drawn_actor found = clq_drawn_actor_init();
    if (!drawn(actor, index, found)) return {};
    std::vector<uint8_t> rgb(3 * static_cast<size_t>(found.zone_count));
    scenes::check(clq_view_get_colours(view_.get(), index, rgb.data(), found.zone_count));
    return rgb;
}

// A sphere round its vertices in the last picture: tighter than its bounding sphere, which holds all of its clips.
bool World::body(clq_actor actor, Point &centre, double &radius) const
{
    uint32_t index = 0;
    clq_drawn_actor found = clq_drawn_actor_init();
    if (!drawn(actor, index, found)) return false;
    std::vector<float> at(3 * static_cast<size_t>(found.vertex_count));
    if (clq_view_get_vertices(view_.get(), index, at.data(), nullptr, found.vertex_count) != CLQ_OK) return false;
    double low[3] = {1e9, 1e9, 1e9}, high[3] = {-1e9, -1e9, -1e9};
    for (size_t k = 0; k + 2 < at.size(); k += 3)
        for (size_t row = 0; row < 3; ++row) {
            const float *m = found.model_view;
            const double seen =
                static_cast<double>(m[row] * at[k] + m[4 + row] * at[k + 1] + m[8 + row] * at[k + 2] + m[12 + row]);
            low[row] = std::min(low[row], seen), high[row] = std::max(high[row], seen);
        }
    radius = 0;
    for (size_t axis = 0; axis < 3; ++axis) {
        centre[axis] = camera_.eye[axis];
        for (size_t row = 0; row < 3; ++row)
            centre[axis] += static_cast<double>(eye_.rotation[4 * axis + row]) * (low[row] + high[row]) / 2;
        radius += (high[axis] - low[axis]) * (high[axis] - low[axis]) / 4;
    }
    radius = std::sqrt(radius);
    return radius > 0;
}

bool World::outline(clq_actor actor, Box &out) const
{
    uint32_t index = 0;
    clq_drawn_actor found = clq_drawn_actor_init();
    if (!drawn(actor, index, found)) return false;
    std::vector<float> at(3 * static_cast<size_t>(found.vertex_count));
    if (clq_view_get_vertices(view_.get(), index, at.data(), nullptr, found.vertex_count) != CLQ_OK) return false;
    out = {1e9f, 1e9f, -1e9f, -1e9f};
    const float *m = found.model_view, *p = camera_.projection;
    for (size_t k = 0; k + 2 < at.size(); k += 3) {
        float eye[3], clip[4];
        for (size_t row = 0; row < 3; ++row)
            eye[row] = m[row] * at[k] + m[4 + row] * at[k + 1] + m[8 + row] * at[k + 2] + m[12 + row];
        for (size_t row = 0; row < 4; ++row)
            clip[row] = p[row] * eye[0] + p[4 + row] * eye[1] + p[8 + row] * eye[2] + p[12 + row];
        if (!(clip[3] > 1e-6f)) return false;
        const float x = (clip[0] / clip[3] + 1) / 2 * static_cast<float>(width_);
        const float y = (1 - clip[1] / clip[3]) / 2 * static_cast<float>(height_);
        out = {std::min(out.x0, x), std::min(out.y0, y), std::max(out.x1, x), std::max(out.y1, y)};
    }
    return out.x1 > out.x0;
}

bool World::on_picture(clq_actor actor, float &x, float &y, float &radius) const
{
    clq_scene_actor body = clq_scene_actor_init();
    if (clq_scene_get_actor(index_, actor, time_s_, &body) != CLQ_OK || !body.present) return false;
    double across = 0, up = 0;
    if (!project(camera_, {body.centre[0], body.centre[1], body.centre[2]}, across, up)) return false;
    x = static_cast<float>((across + 1) / 2 * width_);
    y = static_cast<float>((1 - up) / 2 * height_);
    double squared = 0;
    for (int k = 0; k < 3; ++k) squared += (body.centre[k] - camera_.eye[k]) * (body.centre[k] - camera_.eye[k]);
    const double high = static_cast<double>(camera_.projection[5]) * height_ / 2;
    radius = static_cast<float>(body.radius * high / std::sqrt(std::max(1e-6, squared)));
    return true;
}

bool World::point_on(uint32_t index1, float &x, float &y) const
{
    constexpr int steps = 24;
    for (const clq_actor actor : everyone()) {
        float cx = 0, cy = 0, radius = 0;
        if (actor.index1 != index1 || !on_picture(actor, cx, cy, radius)) continue;
        // From the middle outwards, so that a click meets the body rather than a finger.
        for (int ring = 0; ring <= steps / 2; ++ring)
            for (int k = 0; k < steps; ++k) {
                const double angle = 6.283185307179586 * k / steps, away = radius * 2.0 * ring / steps;
                x = std::floor(cx + static_cast<float>(away * std::cos(angle))) + 0.5f;
                y = std::floor(cy + static_cast<float>(away * std::sin(angle))) + 0.5f;
                if (x < 0 || y < 0 || x >= static_cast<float>(width_) || y >= static_cast<float>(height_)) continue;
                const Picked met =
                    pick(2 * x / static_cast<float>(width_) - 1, 1 - 2 * y / static_cast<float>(height_));
                if (met.actor.index1 == index1) return true;
            }
    }
    return false;
}

// In the last update: a pose of another tick was made anew, unless nothing is kept.
Served World::served_of(clq_actor actor, const clq_actor_info &info)
{
    const auto before = ticks_.find(actor.index1);
    const bool kept = before != ticks_.end() && before->second == info.tick_s && made_.cache != CLQ_CACHE_NONE;
    ticks_[actor.index1] = info.tick_s;
    if (!kept) return Served::nothing;
    return made_.cache == CLQ_CACHE_ANIMATION ? Served::palette : Served::vertices;
}

void World::tint(Model &model)
{
    if (model.tint == Tint::nothing) return;
    std::vector<float> rgb;
    model.served = {};
    for (const clq_actor actor : everyone()) {
        clq_actor_info info = clq_actor_info_init();
        if (!find(actor, info) || !info.visible) continue;
        const Served served = served_of(actor, info);
        ++model.served[static_cast<size_t>(served)];
        clq_template_info tmpl = clq_template_info_init();
        scenes::check(clq_template_get_info(info.tmpl, &tmpl));
        const Rgb3 colour = model.tint == Tint::cache ? heat(static_cast<double>(served) * 0.375)
                                                      : tint_of(model.tint, info, model.clock.time_s);
        rgb.clear();
        for (uint32_t zone = 0; zone < tmpl.zone_count; ++zone) rgb.insert(rgb.end(), {colour.r, colour.g, colour.b});
        scenes::check(clq_actor_set_colours(scene_->crowd(), actor, rgb.data(), tmpl.zone_count));
    }
}

}  // namespace view
