#include "passes/shadow_mask.h"

#include <cmath>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

namespace claque::passes
{

ShadowMask::ShadowMask(const float *projection, int32_t width, int32_t height, ShadowArrays &arrays, ShadowBatch &batch)
    : projection_(glm::make_mat4(projection)),
      inverse_(glm::inverse(projection_)),
      width_(width),
      height_(height),
      arrays_(arrays),
      batch_(batch)
{
    const glm::dvec4 nearest = inverse_ * glm::dvec4(0, 0, -1, 1);
    nearest_w_ = nearest.w > 0 ? 1 / nearest.w : 1e-6;
    arrays_.mask.begin(width, height);
}

void ShadowMask::find_window(const FlattenedMesh &flat)
{
    glm::vec4 rows[3];  // x, y, w
    for (int k = 0; k < 3; ++k)
        for (int c = 0; c < 4; ++c) rows[k][c] = static_cast<float>(projection_[c][k == 2 ? 3 : k]);
    const float half_x = 0.5f * static_cast<float>(width_), half_y = 0.5f * static_cast<float>(height_);
    const float min_w = static_cast<float>(nearest_w_);
    for (uint32_t v = 0; v < flat.vertices; ++v) {
        const float *p = flat.positions + 3 * size_t(v);
        const auto row = [&](int k) { return rows[k].x * p[0] + rows[k].y * p[1] + rows[k].z * p[2] + rows[k].w; };
        const float x = row(0), y = row(1), w = row(2);
        // For points behind the eye x and y stay undivided; they are clipped first.
        arrays_.window[v] = w >= min_w ? glm::vec3((x / w + 1) * half_x, (y / w + 1) * half_y, w) : glm::vec3(x, y, w);
    }
}

void ShadowMask::add(const ShadowPlane &plane, const FlattenedMesh &flat)
{
    // On a plane window depth is linear over the picture: q * (x, y, z, 1) == 0 in normalised coordinates.
    const glm::dvec4 q = glm::transpose(inverse_) * glm::dvec4(plane.normal, -plane.offset);
    if (std::fabs(q.z) < 1e-12) return;  // the ground is seen edge-on
    slope_x_ = -q.x / q.z, slope_y_ = -q.y / q.z, middle_ = -q.w / q.z;
    find_window(flat);
    for (uint32_t i = 0; i + 2 < flat.count; i += 3)
        add_triangle(arrays_.window[flat.indices[i]], arrays_.window[flat.indices[i + 1]],
                     arrays_.window[flat.indices[i + 2]]);
    arrays_.mask.take([this](const PixelBox &box) { draw(box); });
}

void ShadowMask::add_triangle(const glm::vec3 &a, const glm::vec3 &b, const glm::vec3 &c)
{
    const float min_w = static_cast<float>(nearest_w_);
    const int inside = (a.z >= min_w) + (b.z >= min_w) + (c.z >= min_w);
    if (inside == 3) return arrays_.mask.add(glm::vec2(a), glm::vec2(b), glm::vec2(c));
    if (inside == 0) return;
    // Clips at the near plane (Sutherland and Hodgman 1974), in clip space.
    const float half_x = 0.5f * static_cast<float>(width_), half_y = 0.5f * static_cast<float>(height_);
    const auto in_clip = [&](const glm::vec3 &p) {
        return p.z >= min_w ? glm::vec3((p.x / half_x - 1) * p.z, (p.y / half_y - 1) * p.z, p.z) : p;
    };
    const glm::vec3 corners[3] = {in_clip(a), in_clip(b), in_clip(c)};
    glm::vec2 kept[4];
    int count = 0;
    const auto keep = [&](const glm::vec3 &p) {
        kept[count++] = glm::vec2((p.x / p.z + 1) * half_x, (p.y / p.z + 1) * half_y);
    };
    for (int k = 0; k < 3; ++k) {
        const glm::vec3 &from = corners[k], &to = corners[(k + 1) % 3];
        if (from.z >= min_w) keep(from);
        if ((from.z >= min_w) == (to.z >= min_w)) continue;
        glm::vec3 cut = from + (to - from) * ((min_w - from.z) / (to.z - from.z));
        cut.z = min_w;
        keep(cut);
    }
    for (int k = 2; k < count; ++k) arrays_.mask.add(kept[0], kept[k - 1], kept[k]);
}

// The ground at a corner of a box, in eye space. Close to the horizon a corner may lie above the ground although all
// pixel centres of the box see it; the corner then gets the depth of the nearest of these.
bool ShadowMask::corner(double x, double y, double inner_x, double inner_y, glm::vec3 &out) const
{
    const auto point = [&](double depth_x, double depth_y) {
        const glm::dvec2 at(2 * x / width_ - 1, 2 * y / height_ - 1);
        const glm::dvec2 ground(2 * depth_x / width_ - 1, 2 * depth_y / height_ - 1);
        const double depth = slope_x_ * ground.x + slope_y_ * ground.y + middle_;
        return inverse_ * glm::dvec4(at.x, at.y, depth, 1.0);
    };
    const glm::dvec4 inner = point(inner_x, inner_y);
    if (!(inner.w > 0)) return false;
    const glm::dvec4 outer = point(x, y);
    const glm::dvec4 &taken = outer.w > 0.25 * inner.w ? outer : inner;
    out = glm::vec3(taken.x / taken.w, taken.y / taken.w, taken.z / taken.w);
    return true;
}

void ShadowMask::draw(const PixelBox &box)
{
    const double x0 = box.x0, x1 = box.x1, y0 = box.y0, y1 = box.y1;
    glm::vec3 corners[4];
    if (corner(x0, y0, x0 + 0.5, y0 + 0.5, corners[0]) && corner(x1, y0, x1 - 0.5, y0 + 0.5, corners[1]) &&
        corner(x1, y1, x1 - 0.5, y1 - 0.5, corners[2]) && corner(x0, y1, x0 + 0.5, y1 - 0.5, corners[3]))
        batch_.add(corners);
}

}  // namespace claque::passes
