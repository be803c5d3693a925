#include "lib/lod/proxies/zone_views.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lib/lod/surface/visibility.h"
#include "lib/pose/pose.h"

namespace claque::lod
{

namespace
{

constexpr uint32_t max_clip_poses = 8;  // besides the pose at rest
constexpr int side_px = 48;             // of a view's square, which holds the character

// From the four sides, from above, and from the four upper corners of a cube. Few people are seen from below.
std::vector<glm::dvec3> directions()
{
    std::vector<glm::dvec3> found = {{0, 1, 0}};
    for (int k = 0; k < 4; ++k) {
        const double x = k % 2 ? 0 : 1 - k, z = k % 2 ? 2 - k : 0;
        found.emplace_back(x, 0, z);
        found.push_back(glm::normalize(glm::dvec3(k / 2 ? 1 : -1, 1, k % 2 ? 1 : -1)));
    }
    return found;
}

// A picture in parallel projection that keeps the nearest surface point of each pixel.
class Picture
{
public:
    // `towards`: the direction to the eye. The box from `min` to `max` fills the picture.
    Picture(glm::dvec3 towards, glm::dvec3 min, glm::dvec3 max)
        : towards_(towards),
          right_(glm::normalize(
              glm::cross(std::abs(towards.y) > 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0), towards))),
          up_(glm::cross(towards, right_)),
          middle_(0.5 * (min + max)),
          px_(side_px / std::max(glm::length(max - min), 1e-30)),
          depths_(side_px * side_px, -std::numeric_limits<double>::infinity()),
          points_(side_px * side_px)
    {
        for (SurfacePoint &point : points_) point.triangle = model::none;
    }

    // `is_hole`: whether a point of the triangle is one.
    template <class IsHole>
    void add(uint32_t triangle, const std::array<glm::dvec3, 3> &corners, bool two_sided, IsHole is_hole)
    {
        if (!two_sided && glm::dot(glm::cross(corners[1] - corners[0], corners[2] - corners[0]), towards_) <= 0) return;
        std::array<glm::dvec3, 3> at;  // pixels right and up, and depth
        glm::dvec3 min(std::numeric_limits<double>::infinity()), max = -min;
        for (size_t k = 0; k < 3; ++k) {
            const glm::dvec3 off = px_ * (corners[k] - middle_);
            at[k] = {glm::dot(off, right_) + 0.5 * side_px, glm::dot(off, up_) + 0.5 * side_px,
                     glm::dot(off, towards_)};
            min = glm::min(min, at[k]), max = glm::max(max, at[k]);
        }
        const glm::dvec3 a = at[1] - at[0], b = at[2] - at[0];
        const double area = a.x * b.y - a.y * b.x;
        if (area == 0) return;
        for (int y = first(min.y); y < end(max.y); ++y)
            for (int x = first(min.x); x < end(max.x); ++x) {
                const double px = x + 0.5 - at[0].x, py = y + 0.5 - at[0].y;
                const double u = (px * b.y - py * b.x) / area, v = (a.x * py - a.y * px) / area;
                if (u < 0 || v < 0 || u + v > 1) continue;
                const double depth = at[0].z + u * a.z + v * b.z;
                const size_t pixel = size_t(y) * side_px + size_t(x);
                const SurfacePoint point = {triangle, {1 - u - v, u, v}};
                if (depth > depths_[pixel] && !is_hole(point)) depths_[pixel] = depth, points_[pixel] = point;
            }
    }
    const std::vector<SurfacePoint> &points() const { return points_; }

private:
    static int first(double least) { return std::clamp(static_cast<int>(std::floor(least - 0.5)), 0, side_px); }
    static int end(double most) { return std::clamp(static_cast<int>(std::ceil(most + 0.5)), 0, side_px); }

    glm::dvec3 towards_, right_, up_, middle_;
    double px_;
    std::vector<double> depths_;
    std::vector<SurfacePoint> points_;
};

}  // namespace

template <class Take>
void ZoneViews::draw(PosedParts &parts, Take take) const
{
    const std::vector<glm::dvec3> eyes = directions();
    for (const Pose &pose : poses_) {
        parts.pose(model_.rig, base::Span<const math::Affine>(pose.palette), base::Span<const float>(pose.weights));
        glm::dvec3 min(std::numeric_limits<double>::infinity()), max = -min;
        for (const glm::dvec3 &p : parts.positions()) min = glm::min(min, p), max = glm::max(max, p);
        for (const glm::dvec3 &eye : eyes) {
            Picture picture(eye, min, max);
            for (uint32_t t = 0; t < parts.triangles().size(); ++t) {
                const PosedParts::Triangle &triangle = parts.triangles()[t];
                picture.add(t, parts.corners(triangle), is_two_sided(model_, parts.part(triangle.part)),
                            [&](const SurfacePoint &point) { return is_hole(model_, parts, point); });
            }
            take(picture.points());
        }
    }
}

ZoneViews::ZoneViews(const model::Model &model, const std::vector<const model::Part *> &source) : model_(model)
{
    pose::Workspace workspace(model.rig);
    const auto add_pose = [&](uint32_t clip, double time_s) {
        const base::Span<const math::Affine> palette = workspace.pose(clip, time_s);
        const base::Span<const float> weights = workspace.weights();
        poses_.push_back({{palette.begin(), palette.end()}, {weights.begin(), weights.end()}});
    };
    add_pose(model::none, 0);
    const uint32_t clips = static_cast<uint32_t>(model.rig.clips.size()), count = std::min(clips, max_clip_poses);
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t clip = (2 * i + 1) * clips / (2 * count);
        add_pose(clip, double(model.rig.clips[clip].start_s) + 0.5 * double(model.rig.clips[clip].duration_s));
    }
    fractions_ = fractions_of(source);
}

std::vector<std::vector<double>> ZoneViews::fractions_of(const std::vector<const model::Part *> &shown) const
{
    PosedParts parts(shown);
    std::vector<std::vector<double>> found;
    draw(parts, [&](const std::vector<SurfacePoint> &points) {
        std::vector<double> pixels(model_.zones.size() + 1, 0);
        double all = 0;
        for (const SurfacePoint &point : points) {
            if (point.triangle == model::none) continue;
            ++pixels[std::min<size_t>(zone_at(model_, parts, point), model_.zones.size())], ++all;
        }
        for (double &one : pixels) one /= std::max(all, 1.0);
        found.push_back(std::move(pixels));
    });
    return found;
}

double ZoneViews::error(const model::Part &level) const
{
    const std::vector<std::vector<double>> shown = fractions_of({&level});
    double sum = 0;
    for (size_t v = 0; v < count(); ++v)
        for (size_t z = 0; z < shown[v].size(); ++z) sum += 0.5 * std::abs(shown[v][z] - fractions_[v][z]);
    return sum / double(count());
}

std::vector<std::vector<double>> ZoneViews::triangle_fractions(const model::Part &level) const
{
    PosedParts parts({&level});
    std::vector<std::vector<double>> found;
    draw(parts, [&](const std::vector<SurfacePoint> &points) {
        std::vector<double> pixels(parts.triangles().size(), 0);
        double all = 0;
        for (const SurfacePoint &point : points)
            if (point.triangle != model::none) ++pixels[point.triangle], ++all;
        for (double &one : pixels) one /= std::max(all, 1.0);
        found.push_back(std::move(pixels));
    });
    return found;
}

}  // namespace claque::lod
