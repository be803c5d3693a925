// proxy_meshes (proxy.h): one closed surface round all parts.
#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lib/lod/proxies/coarsen.h"
#include "lib/lod/proxies/proxy.h"
#include "lib/lod/proxies/reduce.h"
#include "lib/lod/surface/joint_displacement.h"
#include "lib/lod/surface/nearest.h"
#include "lib/lod/surface/surface_samples.h"
#include "lib/model/model_size.h"
#include "lib/pose/pose.h"

namespace claque::lod
{

namespace
{

constexpr uint32_t max_influences = 4;
// The cost of an influence, as a fraction of the joint displacement and of the size; the latter because hosts may have
// other clips. Found by experiment.
constexpr double displacement_cost = 0.5, min_cost = 0.05;
constexpr size_t max_reduced_triangles = 128;   // levels of at most so many triangles use reduce_by_distance()
constexpr size_t reduced_from_triangles = 180;  // where it begins, whatever the targets are
constexpr size_t stand_in_triangles = 1000;     // triangles of the mesh that replaces the fine surface for those
constexpr uint32_t least_cells = 12;            // along the longest side, however little was read
constexpr uint32_t first_zone = 0x80000000u;    // feature ids from here on are zones; those below are joints

struct Influence {
    uint32_t joint = 0;
    double weight = 0;
};

// Returns the features of a point: its joints and its zone.
Attributes features_at(const model::Model &model, const PosedParts &parts, const SurfacePoint &point,
                       const std::vector<double> &influences, double zone_cost)
{
    Attributes found;
    const auto add = [&](uint32_t id, double value) {
        const auto same = std::find_if(found.begin(), found.end(), [&](const Attribute &a) { return a.id == id; });
        if (same != found.end()) same->value += value;
        else found.push_back({id, value});
    };
    const PosedParts::Triangle &t = parts.triangles()[point.triangle];
    const model::Part &part = parts.part(t.part);
    for (size_t k = 0; k < 3; ++k)
        for (size_t i = 0; i < part.influence_count; ++i) {
            const size_t at = size_t(t.vertices[k]) * part.influence_count + i;
            const double weight = point.weights[static_cast<int>(k)] * double(part.weights[at]);
            if (weight > 0) add(part.joints[at], influences[part.joints[at]] * weight);
        }
    const uint32_t zone = is_hole(model, parts, point) ? model::none : zone_at(model, parts, point);
    if (zone != model::none) add(first_zone + zone, zone_cost);
    std::sort(found.begin(), found.end(), [](const Attribute &a, const Attribute &b) { return a.id < b.id; });
    return found;
}

// Returns the influences, heaviest first.
std::vector<Influence> influences_of(const Features &features, const std::vector<double> &costs)
{
    std::vector<Influence> found;
    for (const Attribute &attribute : features.mean)
        if (attribute.id < first_zone && attribute.value > 0)
            found.push_back({attribute.id, attribute.value / costs[attribute.id]});
    std::sort(found.begin(), found.end(), [](const Influence &a, const Influence &b) {
        return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
    });
    found.resize(std::min<size_t>(found.size(), max_influences));
    double sum = 0;
    for (const Influence &f : found) sum += f.weight;
    for (Influence &f : found) f.weight /= sum;
    return found;
}

// Moves a vertex of the proxy to just above the nearest surface point, on its own side, so that the two sides of a
// sheet stay apart.
// Vertices of the closed surface, whose number depends on the shape and not on what was read: they may take half of
// what levels may take (docs/levels.md).
size_t most_vertices(const model::Model &model)
{
    constexpr uint64_t multiple = 64, always_bytes = 16ull << 20, bytes_of_vertex = 1200;
    return static_cast<size_t>((multiple * model::source_bytes(model) + always_bytes) / 2 / bytes_of_vertex);
}

glm::dvec3 shrink_to_surface(glm::dvec3 p, glm::dvec3 nearest, double cell)
{
    const glm::dvec3 off = p - nearest;
    const double distance = glm::length(off);
    if (distance > 1.5 * cell) return p;  // it closes an opening
    const double stay = 0.1 * cell;
    return distance > stay ? nearest + off * (stay / distance) : p;
}

// Returns vertex normals, summed over the triangles round each vertex.
std::vector<glm::dvec3> normals_of(const ClosedMesh &surface)
{
    std::vector<glm::dvec3> sums(surface.positions.size(), glm::dvec3(0));
    for (const auto &t : surface.triangles) {
        const glm::dvec3 a = surface.positions[t[0]], b = surface.positions[t[1]], c = surface.positions[t[2]];
        for (const uint32_t v : t) sums[v] += glm::cross(b - a, c - a);
    }
    return sums;
}

math::Affine blended(const std::vector<Influence> &influences, base::Span<const math::Affine> palette)
{
    math::Affine sum;
    for (float &c : sum.c) c = 0;
    for (const Influence &f : influences)
        for (size_t i = 0; i < 12; ++i) sum.c[i] += static_cast<float>(f.weight) * palette[f.joint].c[i];
    return sum;
}

// Drops the lightest influences while the blended matrix is nearly singular at rest: other poses would throw the vertex
// far away.
void drop_unstable_influences(std::vector<Influence> &influences, base::Span<const math::Affine> palette)
{
    // Minimum determinant of the blend, as a fraction of the heaviest joint's.
    constexpr float least = 0.5f;
    const auto space = [&] { return std::abs(math::determinant(blended(influences, palette))); };
    const float own = std::abs(math::determinant(palette[influences[0].joint]));
    while (influences.size() > 1 && space() < least * own) {
        const double lost = influences.back().weight;
        influences.pop_back();
        for (Influence &f : influences) f.weight /= 1 - lost;
    }
}

model::Part part_of(const std::string &name, const CoarseMesh &coarse, const std::vector<double> &costs,
                    base::Span<const math::Affine> palette)
{
    model::Part part;
    part.name = name, part.skinned = true, part.influence_count = max_influences;
    const std::vector<glm::dvec3> normals = normals_of(coarse.surface);
    for (size_t v = 0; v < normals.size(); ++v) {
        std::vector<Influence> influences = influences_of(coarse.features[v], costs);
        drop_unstable_influences(influences, palette);
        const math::Affine back = math::inverse(blended(influences, palette));
        part.positions.push_back(math::transform_point(back, glm::vec3(coarse.surface.positions[v])));
        const glm::vec3 n = math::transform_vector(math::normal_matrix(back), glm::vec3(normals[v]));
        const float length = glm::length(n);
        part.normals.push_back(length > 0 ? n / length : glm::vec3(0, 1, 0));
        for (uint32_t k = 0; k < max_influences; ++k) {
            part.joints.push_back(k < influences.size() ? influences[k].joint : 0);
            part.weights.push_back(k < influences.size() ? static_cast<float>(influences[k].weight) : 0);
        }
    }
    for (const auto &t : coarse.surface.triangles) part.indices.insert(part.indices.end(), t.begin(), t.end());
    return part;
}

double size_of(const std::vector<Voxels::Triangle> &triangles)
{
    glm::dvec3 first = triangles[0][0], last = first;
    for (const Voxels::Triangle &t : triangles)
        for (const glm::dvec3 p : t) first = glm::min(first, p), last = glm::max(last, p);
    return std::max({last.x - first.x, last.y - first.y, last.z - first.z});
}

// Returns [palette] the cost of an influence, from joint displacements, or as a fraction of the size if there are no
// clips.
std::vector<double> proxy_influence_costs(const model::Model &model, const std::vector<const model::Part *> &source,
                                          const ProxyMeshOptions &options, double size)
{
    const std::vector<std::vector<glm::vec3>> rest = rest_positions(model.rig, source);
    std::vector<SourcePart> pieces;
    for (size_t i = 0; i < source.size(); ++i) pieces.push_back({source[i], &rest[i]});
    std::vector<double> costs = joint_displacements(model, pieces);
    for (double &cost : costs) cost = displacement_cost * cost + min_cost * size;
    costs.resize(model.rig.palette.size(), options.influence * size);
    return costs;
}

// Simplifies by quadrics while limbs have many triangles each, then by distance.
std::vector<CoarseMesh> coarse_levels(const ClosedMesh &surface, const std::vector<Attributes> &features,
                                      const std::vector<size_t> &targets, const base::Jobs &jobs)
{
    const auto few = std::find_if(targets.begin(), targets.end(), [](size_t n) { return n <= max_reduced_triangles; });
    std::vector<size_t> many(targets.begin(), few);
    if (few == targets.end()) return coarsen(surface, features, many);
    const auto insert = [&](size_t triangles) {
        const auto at = std::find_if(many.begin(), many.end(), [&](size_t n) { return n < triangles; }) - many.begin();
        many.insert(many.begin() + at, triangles);
        return at;
    };
    const ptrdiff_t stand_in_at = insert(stand_in_triangles), from_at = insert(reduced_from_triangles);
    std::vector<CoarseMesh> levels = coarsen(surface, features, many);
    const CoarseMesh stand_in = std::move(levels[size_t(stand_in_at)]), from = std::move(levels[size_t(from_at)]);
    levels.erase(levels.begin() + from_at), levels.erase(levels.begin() + stand_in_at);
    std::vector<Attributes> means;
    for (const Features &one : stand_in.features) means.push_back(one.mean);
    const FineSurface fine(stand_in.surface, means, means.size());
    for (CoarseMesh &level : reduce_by_distance(fine, from, {few, targets.end()}, jobs))
        levels.push_back(std::move(level));
    return levels;
}

Voxels filled(const std::vector<Voxels::Triangle> &triangles, uint32_t cells)
{
    Voxels voxels(triangles, cells);
    voxels.fill();
    return voxels;
}

}  // namespace

std::vector<model::Part> proxy_meshes(const model::Model &model, const std::vector<const model::Part *> &source,
                                      const ProxyMeshOptions &options)
{
    PosedParts posed(source);
    pose::Workspace workspace(model.rig);
    const base::Span<const math::Affine> palette = workspace.pose(model::none, 0);
    posed.pose(model.rig, palette, workspace.weights());
    std::vector<Voxels::Triangle> triangles;
    for (const PosedParts::Triangle &t : posed.triangles()) triangles.push_back(posed.corners(t));
    const double size = size_of(triangles);
    Voxels voxels = filled(triangles, options.cells);
    ClosedMesh surface = extract_closed_mesh(voxels);
    for (uint32_t cells = options.cells; surface.positions.size() > most_vertices(model) && cells > least_cells;) {
        cells -= cells / 4;
        voxels = filled(triangles, cells);
        surface = extract_closed_mesh(voxels);
    }
    const NearestPoint nearest(std::move(triangles));

    const std::vector<double> costs = proxy_influence_costs(model, source, options, size);
    std::vector<Attributes> features;
    for (glm::dvec3 &p : surface.positions) {
        const NearestPoint::Found found = nearest.to(p);
        const SurfacePoint point = {found.triangle, found.weights};
        features.push_back(features_at(model, posed, point, costs, options.zone * size));
        p = shrink_to_surface(p, position_of(posed, point), voxels.cell());
    }
    std::vector<model::Part> parts;
    for (const CoarseMesh &coarse : coarse_levels(surface, features, options.targets, options.jobs))
        parts.push_back(part_of(model.name, coarse, costs, palette));
    return parts;
}

}  // namespace claque::lod
