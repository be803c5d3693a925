#include "lib/lod/decimation/decimate.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "lib/base/error.h"
#include "lib/lod/decimation/add_module.h"
#include "lib/lod/decimation/decimated_parts.h"
#include "lib/lod/decimation/decimater_modules.h"
#include "lib/lod/surface/joint_displacement.h"

namespace claque::lod
{

namespace
{

LevelTriangles level_triangles(const WeldedSurface &surface, const UvOrientations &orientations)
{
    LevelTriangles remaining;
    for (const Mesh::FaceHandle face : surface.mesh.all_faces()) {
        if (surface.mesh.status(face).deleted()) continue;
        std::array<uint32_t, 3> t{};
        size_t k = 0;
        for (auto v = surface.mesh.cfv_iter(face); v.is_valid() && k < 3; ++v)
            t[k++] = surface.mesh.property(surface.corners, face).of(v->idx());
        remaining.triangles.push_back({LevelVertex{t[0], t[0]}, LevelVertex{t[1], t[1]}, LevelVertex{t[2], t[2]}});
        remaining.flipped += orientations.flipped(surface, face, t);
    }
    return remaining;
}

// Returns metres per unit of u or v, from the total areas of all triangles in space and in the texture.
double metres_per_uv(const WeldedSurface &surface)
{
    double here = 0, there = 0;
    for (const Mesh::FaceHandle face : surface.mesh.faces()) {
        const Corners &corners = surface.mesh.property(surface.corners, face);
        if (!surface.has_uv(corners.corner[0])) continue;
        std::array<glm::dvec3, 3> p, t;
        for (size_t k = 0; k < 3; ++k) {
            p[k] = point(surface.mesh, Mesh::VertexHandle(corners.at[k]));
            t[k] = glm::dvec3(glm::dvec2(surface.uv(corners.corner[k])), 0);
        }
        here += TriangleFrame(p[0], p[1], p[2]).area;
        there += TriangleFrame(t[0], t[1], t[2]).area;
    }
    return there > 0 ? std::sqrt(here / there) : 0;
}

size_t faces_of(const Mesh &mesh)
{
    size_t count = 0;
    for (const Mesh::FaceHandle face : mesh.all_faces()) count += !mesh.status(face).deleted();
    return count;
}

double size_of(const WeldedSurface &surface)
{
    glm::dvec3 min(std::numeric_limits<double>::infinity()), max = -min;
    for (const Mesh::VertexHandle v : surface.mesh.vertices()) {
        const glm::dvec3 p = point(surface.mesh, v);
        min = glm::min(min, p), max = glm::max(max, p);
    }
    return std::max({max.x - min.x, max.y - min.y, max.z - min.z});
}

// Minimum cost, as a fraction of the size, of swapping joints that no clip separates: a host's clips may separate them.
constexpr double min_influence_cost = 0.01;

// Returns the cost of moving a whole influence away from each palette entry, in metres.
std::vector<double> influence_costs(const std::vector<SourcePart> &parts, const DecimationOptions &options, double size)
{
    std::vector<double> found;
    if (options.model) found = joint_displacements(*options.model, parts);
    for (double &one : found) one = options.joint_displacement * one + min_influence_cost * size;
    uint32_t entries = static_cast<uint32_t>(found.size());
    for (const SourcePart &piece : parts)
        for (const uint32_t joint : piece.part->joints) entries = std::max(entries, joint + 1);
    found.resize(entries, options.influence * size);
    return found;
}

// Triangles that are left when the zones' areas are measured again, and the costs of all collapses with them. Those of
// many triangles move little.
size_t kept_percent(size_t triangles) { return triangles > 4000 ? 80 : 97; }

}  // namespace

std::vector<Decimated> decimate(const std::vector<SourcePart> &parts, const DecimationOptions &options)
{
    namespace om = OpenMesh::Decimater;
    WeldedSurface surface(parts);
    if (surface.mesh.n_faces() == 0) base::fail(CLQ_ARGUMENT, "%zu parts have no triangles to decimate", parts.size());
    if (options.targets.empty()) base::fail(CLQ_ARGUMENT, "a decimation has no target");
    om::DecimaterT<Mesh> decimater(surface.mesh);
    om::ModHandleT<ModCost<Mesh>> cost;
    om::ModHandleT<ModFlips<Mesh>> flips;
    om::ModHandleT<ModSeams<Mesh>> seams;
    add_module(decimater, cost);
    add_module(decimater, seams);
    add_module(decimater, flips);
    decimater.module(seams).configure(&surface);
    decimater.module(flips).configure(&surface, options.turn_deg);
    std::unique_ptr<ZoneAreaCost> zone_area;
    if (options.model && options.model->zones.size() > 1 && options.zone_area > 0)
        zone_area = std::make_unique<ZoneAreaCost>(surface, *options.model, options.zone_area);
    decimater.module(cost).configure(
        &surface,
        {influence_costs(parts, options, size_of(surface)), options.texture * metres_per_uv(surface), 1, options.area},
        zone_area.get());
    if (!decimater.initialize()) base::fail(CLQ_ARGUMENT, "part '%s' cannot be decimated", parts[0].part->name.c_str());
    const UvOrientations orientations(surface);
    std::vector<LevelTriangles> remaining;
    bool stuck = false;  // no legal collapse is left, so that all further levels would be the same
    for (size_t k = 0; k < options.targets.size() && !stuck; ++k) {
        const size_t target = options.targets[k];
        for (size_t before = faces_of(surface.mesh), now = before; before > target; before = now) {
            if (zone_area) zone_area->measure();
            const size_t next = zone_area ? std::max(target, before * kept_percent(before) / 100) : target;
            // OpenMesh counts deleted faces until they are collected; collecting would invalidate the handles that
            // corners are kept by.
            decimater.decimate_to_faces(0, next + surface.mesh.n_faces() - before);
            now = faces_of(surface.mesh);
            stuck = now == before || now > next;
            if (stuck) break;
        }
        remaining.push_back(level_triangles(surface, orientations));
    }
    return build_decimated(surface, parts.size(), remaining);
}

}  // namespace claque::lod
