#include "meshsplit/spheres.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "meshsplit/known_vertices.h"
#include "meshsplit/reach.h"
#include "meshsplit/vertex_cloud.h"

namespace claque::meshsplit
{

using math::Affine;
using model::none;
using Palette = std::vector<Affine>;

namespace
{

constexpr double samples_per_s = 60;

// Returns about the centre of the smallest sphere round a few points: moves it towards the farthest point in ever
// smaller steps.
glm::dvec3 centre_of(const std::vector<glm::dvec3> &points)
{
    glm::dvec3 centre(0);
    for (const glm::dvec3 &p : points) centre += p / double(points.size());
    for (int step = 1; step <= 2000; ++step) {
        const glm::dvec3 *far = &points[0];
        for (const glm::dvec3 &p : points)
            if (glm::dot(p - centre, p - centre) > glm::dot(*far - centre, *far - centre)) far = &p;
        centre += (*far - centre) / double(step + 1);
    }
    return centre;
}

std::vector<glm::vec3> directions()
{
    std::vector<glm::vec3> out;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x || y || z) out.push_back(glm::normalize(glm::vec3(x, y, z)));
    return out;
}

// Bounds how far the arc between two positions of a rigid body exceeds the chord: chord / 2 * tan(angle / 4), doubled
// because joints above may rotate about other points at the same time.
struct Turn {
    double tangent;  // tan(angle / 4)

    Turn(const Affine &a, const Affine &b)
    {
        double cosine = -1;
        for (int k = 0; k < 3; ++k) {
            const double size = double(glm::length(a.column(k))) * glm::length(b.column(k));
            cosine += size > 0 ? double(glm::dot(a.column(k), b.column(k))) / size : 1.0;
        }
        cosine = std::clamp(cosine / 2, -1.0, 1.0);
        const double half = std::sqrt((1 + cosine) / 2);
        tangent = std::sqrt((1 - half) / (1 + half));
    }
    double bulge(double chord) const { return chord * tangent; }
};

class SphereFinder
{
public:
    // `left_out`: per level the vertices that FreeReach bounds, or empty.
    SphereFinder(const model::Template &tmpl, std::vector<PoseAt> poses,
                 const std::vector<std::vector<uint8_t>> &left_out = {})
        : tmpl_(tmpl), poses_(std::move(poses)), workspace_(tmpl.rig)
    {
        KnownVertices known;
        for (size_t i = 0; i < tmpl.levels.size(); ++i) {
            std::vector<uint8_t> out = known.among(tmpl.levels[i]);
            for (size_t v = 0; !left_out.empty() && v < out.size(); ++v) out[v] |= left_out[i][v];
            clouds_.emplace_back(tmpl.levels[i], tmpl.rig, out.data());
        }
    }

    // Finds the sphere round a given centre, with at least this radius. Skins at most `vertices`.
    model::Sphere run(const glm::vec3 &centre, double radius, uint64_t vertices)
    {
        vertices_left_ = vertices;
        sphere_.centre = centre;
        radius_ = radius;
        for (size_t i = 0; i < poses_.size(); ++i) {
            const auto &pose = take(i);
            for (const VertexCloud &cloud : clouds_) grow(cloud, pose);
        }
        // Skinning in float may round outwards.
        sphere_.radius = static_cast<float>(radius_ * (1 + 1e-5));
        return sphere_;
    }

    // Returns the farthest vertices in each of 26 directions, with degrees of freedom at rest. They serve only to find
    // a centre, so within a motion every fourth pose is enough.
    std::vector<glm::dvec3> extremes()
    {
        const std::vector<glm::vec3> axes = directions();
        std::vector<float> maximum(axes.size(), -std::numeric_limits<float>::infinity());
        std::vector<glm::dvec3> points(axes.size());
        for (size_t i = 0; i < poses_.size(); ++i) {
            const bool amid = i > 0 && is_continuous(poses_, i - 1) && is_continuous(poses_, i);
            if (amid && i % 4 != 0) continue;
            const auto palette = workspace_.pose(poses_[i].clip, poses_[i].time_s);
            for (const VertexCloud &cloud : clouds_)
                for (const uint32_t v : cloud.outer()) {
                    const glm::vec3 p = cloud.skinned(v, palette.data, workspace_.weights().data);
                    for (size_t k = 0; k < axes.size(); ++k)
                        if (glm::dot(p, axes[k]) > maximum[k])
                            maximum[k] = glm::dot(p, axes[k]), points[k] = glm::dvec3(p);
                }
        }
        return points;
    }

private:
    struct PoseSample {
        Palette palette;
        std::vector<float> weights;
        std::vector<Turn> turns;  // since the pose before; empty if no motion leads here
    };
    struct Pose {
        const PoseSample *before, *here, *after;  // before and after: null if no motion leads there
    };

    Pose take(size_t i)
    {
        if (i == 0) fill(0);
        if (i + 1 < poses_.size()) fill(i + 1);
        Pose pose{nullptr, &pose_samples_[i % 3], nullptr};
        if (i > 0 && is_continuous(poses_, i - 1)) pose.before = &pose_samples_[(i + 2) % 3];
        if (is_continuous(poses_, i)) pose.after = &pose_samples_[(i + 1) % 3];
        return pose;
    }

    void fill(size_t i)
    {
        PoseSample &pose_sample = pose_samples_[i % 3];
        const auto palette = workspace_.pose(poses_[i].clip, poses_[i].time_s);
        pose_sample.palette.assign(palette.begin(), palette.end());
        pose_sample.weights.assign(workspace_.weights().begin(), workspace_.weights().end());
        pose_sample.turns.clear();
        if (i > 0 && is_continuous(poses_, i - 1))
            for (size_t j = 0; j < pose_sample.palette.size(); ++j)
                pose_sample.turns.emplace_back(pose_samples_[(i - 1) % 3].palette[j], pose_sample.palette[j]);
    }

    void grow(const VertexCloud &cloud, const Pose &pose)
    {
        const double morphing = cloud.max_morph_offset(pose.here->weights.data());
        for (uint32_t j = 0; j < pose.here->palette.size(); ++j) {
            if (!cloud.has(j)) continue;
            const double reach = reach_of_entry(cloud, pose, j, morphing);
            if (reach <= radius_) continue;
            const auto vertices = cloud.vertices(j);
            if (vertices.count > vertices_left_) {
                radius_ = reach;
                continue;
            }
            vertices_left_ -= vertices.count;
            for (const uint32_t v : vertices) radius_ = std::max(radius_, reach_of_vertex(cloud, pose, v));
        }
    }

    // Bounds the distance of every vertex of a palette entry as if the entry moved it alone. Blended vertices lie
    // between such points.
    double reach_of_entry(const VertexCloud &cloud, const Pose &pose, uint32_t j, double morphing) const
    {
        const Affine &m = pose.here->palette[j];
        const double stretch = stretch_of(m);
        const double radius = (double(cloud.sphere(j).radius) + morphing) * stretch;
        const glm::vec3 centre = math::transform_point(m, cloud.sphere(j).centre);
        double bulge = 0;
        for (const PoseSample *other : {pose.before, pose.after}) {
            if (!other) continue;
            const Affine &n = other->palette[j];
            const double chord = glm::distance(math::transform_point(n, cloud.sphere(j).centre), centre) +
                                 4 * turn(pose, other, j).tangent * radius;
            bulge = std::max(bulge, turn(pose, other, j).bulge(chord));
        }
        return double(glm::distance(centre, sphere_.centre)) + radius + bulge;
    }

    double reach_of_vertex(const VertexCloud &cloud, const Pose &pose, uint32_t v) const
    {
        const glm::vec3 here = cloud.skinned(v, pose.here->palette.data(), pose.here->weights.data());
        double bulge = 0;
        for (const PoseSample *other : {pose.before, pose.after}) {
            if (!other) continue;
            const double chord = glm::distance(cloud.skinned(v, other->palette.data(), other->weights.data()), here);
            for (const uint32_t j : cloud.joints(v)) bulge = std::max(bulge, turn(pose, other, j).bulge(chord));
        }
        return double(glm::distance(here, sphere_.centre)) + bulge;
    }

    static const Turn &turn(const Pose &pose, const PoseSample *other, uint32_t j)
    {
        return other == pose.before ? pose.here->turns[j] : pose.after->turns[j];
    }

    double stretch_of(const Affine &m) const
    {
        double longest = 0;
        for (int k = 0; k < 3; ++k) longest = std::max(longest, double(glm::length(m.column(k))));
        return tmpl_.similar_only ? longest * 1.001 : longest * 1.7321;
    }

    const model::Template &tmpl_;
    const std::vector<PoseAt> poses_;
    pose::Workspace workspace_;
    std::vector<VertexCloud> clouds_;
    PoseSample pose_samples_[3];  // pose i is at i % 3
    model::Sphere sphere_;
    double radius_ = 0;
    uint64_t vertices_left_ = 0;  // that may still be skinned
};

// Adds the key times of one channel within the clip, and times just before the keys of a STEP channel.
void add_keys(const model::Rig &rig, const model::Channel &channel, std::vector<double> &times)
{
    for (uint32_t k = 0; k < channel.key_count; ++k) {
        const double time = double(rig.times[channel.first_time + k]);
        times.push_back(time);
        if (channel.interpolation == model::Interpolation::step && k > 0) times.push_back(time - 1e-6);
    }
}

std::vector<double> keys_of(const model::Rig &rig, const model::Clip &clip)
{
    std::vector<double> keys = {double(clip.start_s), double(clip.start_s) + double(clip.duration_s)};
    for (uint32_t c = 0; c < clip.channel_count; ++c) add_keys(rig, rig.channels[clip.first_channel + c], keys);
    std::sort(keys.begin(), keys.end());
    return keys;
}

// Samples from one key to the next, without the first.
int pieces_of(double gap) { return static_cast<int>(std::min(1e6, std::ceil(gap * samples_per_s - 0.01))); }

uint64_t samples_between(const std::vector<double> &keys)
{
    uint64_t count = 1;
    for (size_t i = 1; i < keys.size(); ++i)
        if (keys[i] > keys[i - 1]) count += static_cast<uint64_t>(std::max(1, pieces_of(keys[i] - keys[i - 1])));
    return count;
}

}  // namespace

uint64_t sample_count(const model::Rig &rig, uint32_t clip_index)
{
    return samples_between(keys_of(rig, rig.clips[clip_index]));
}

std::vector<double> sample_times(const model::Rig &rig, uint32_t clip_index)
{
    const model::Clip &clip = rig.clips[clip_index];
    const double start = double(clip.start_s), end = start + double(clip.duration_s);
    const std::vector<double> keys = keys_of(rig, clip);
    std::vector<double> out;
    out.reserve(samples_between(keys));
    for (const double key : keys) {
        if (key < start || key > end || (!out.empty() && key - out.back() < 1e-7)) continue;
        if (!out.empty()) {
            const double from = out.back(), gap = key - from;
            const int pieces = pieces_of(gap);
            for (int i = 1; i < pieces; ++i) out.push_back(from + gap * i / pieces);
        }
        out.push_back(key);
    }
    return out;
}

std::optional<model::Sphere> enclosing_sphere(const model::Template &tmpl, const SearchLimits &limits)
{
    SphereFinder all(tmpl, poses_of(tmpl.rig));
    const std::vector<glm::dvec3> extremes = all.extremes();
    const auto reached_from = [&](const glm::vec3 &centre) {
        double reached = 0;
        for (const glm::dvec3 &p : extremes) reached = std::max(reached, glm::distance(p, glm::dvec3(centre)));
        return reached;
    };
    if (tmpl.rig.dofs.empty()) {
        const glm::vec3 centre(centre_of(extremes));
        return all.run(centre, reached_from(centre), limits.vertices);
    }
    FreeReach free(tmpl, limits.poses);
    if (free.poses().empty()) return {};
    const glm::vec3 centre(free.centre(extremes));
    const double reached = reached_from(centre);
    return SphereFinder(tmpl, free.poses(), free.moved())
        .run(centre, free.radius(glm::dvec3(centre), reached, limits.precise), limits.vertices);
}

}  // namespace claque::meshsplit
