#include "lib/lod/decimate.h"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <algorithm>
#include <cmath>
#include <memory>

#include "lib/base/error.h"
#include "lib/lod/compact.h"
#include "lib/lod/rules.h"
#include "lib/lod/sway.h"

namespace claque::lod
{

namespace
{

Left left_of(const Surface &surface, const UvSides &sides)
{
    Left left;
    for (const Mesh::FaceHandle face : surface.mesh.all_faces()) {
        if (surface.mesh.status(face).deleted()) continue;
        std::array<uint32_t, 3> t{};
        size_t k = 0;
        for (auto v = surface.mesh.cfv_iter(face); v.is_valid() && k < 3; ++v)
            t[k++] = surface.mesh.property(surface.corners, face).of(v->idx());
        left.triangles.push_back({Vertex{t[0], t[0]}, Vertex{t[1], t[1]}, Vertex{t[2], t[2]}});
        left.flipped += sides.flipped(surface, face, t);
    }
    return left;
}

// Metres for each 1 of u or v, from the areas of all triangles here and in the texture.
double metres_per_uv(const Surface &surface)
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

double size_of(const Surface &surface)
{
    glm::dvec3 first(std::numeric_limits<double>::infinity()), last = -first;
    for (const Mesh::VertexHandle v : surface.mesh.vertices()) {
        const glm::dvec3 p = point(surface.mesh, v);
        first = glm::min(first, p), last = glm::max(last, p);
    }
    return std::max({last.x - first.x, last.y - first.y, last.z - first.z});
}

// What joints cost that the clips do not part: a host's may.
constexpr double least_influence = 0.01;

// What it costs that an influence goes from one entry of the palette to another, in metres.
std::vector<double> influences_of(const std::vector<Piece> &parts, const Decimation &wish, double size)
{
    std::vector<double> found;
    if (wish.model) found = sways_of(*wish.model, parts);
    for (double &one : found) one = wish.sway * one + least_influence * size;
    uint32_t entries = static_cast<uint32_t>(found.size());
    for (const Piece &piece : parts)
        for (const uint32_t joint : piece.part->joints) entries = std::max(entries, joint + 1);
    found.resize(entries, wish.influence * size);
    return found;
}

}  // namespace

std::vector<Decimated> decimate(const std::vector<Piece> &parts, const Decimation &wish, const base::Jobs &jobs)
{
    namespace om = OpenMesh::Decimater;
    omerr().disable();
    Surface surface(parts);
    if (surface.mesh.n_faces() == 0) base::fail(CLQ_ARGUMENT, "%zu parts have no triangles to decimate", parts.size());
    if (wish.targets.empty()) base::fail(CLQ_ARGUMENT, "a decimation has no target");
    om::DecimaterT<Mesh> decimater(surface.mesh);
    om::ModHandleT<ModCost<Mesh>> cost;
    om::ModHandleT<ModTurns<Mesh>> turns;
    om::ModHandleT<ModSeams<Mesh>> seams;
    decimater.add(cost);
    decimater.add(seams);
    decimater.add(turns);
    decimater.module(seams).use(&surface);
    decimater.module(turns).use(&surface, wish.turn_deg);
    std::unique_ptr<ZoneDrift> drift;
    if (wish.model && wish.model->zones.size() > 1 && wish.drift > 0)
        drift = std::make_unique<ZoneDrift>(surface, *wish.model, wish.drift, jobs);
    decimater.module(cost).use(
        &surface, {influences_of(parts, wish, size_of(surface)), wish.texture * metres_per_uv(surface), 1, wish.area},
        drift.get());
    if (!decimater.initialize()) base::fail(CLQ_ARGUMENT, "part '%s' cannot be decimated", parts[0].part->name.c_str());
    const UvSides sides(surface);
    std::vector<Left> left;
    for (const size_t target : wish.targets) {
        for (size_t before = faces_of(surface.mesh), now = before; before > target; before = now) {
            if (drift) drift->measure();
            const size_t next = drift ? std::max(target, before * 97 / 100) : target;
            // OpenMesh counts faces that are gone until they are collected, and its handles are what corners are kept by.
            decimater.decimate_to_faces(0, next + surface.mesh.n_faces() - before);
            now = faces_of(surface.mesh);
            if (now == before || now > next) break;
        }
        left.push_back(left_of(surface, sides));
    }
    return compact(surface, parts.size(), left);
}

}  // namespace claque::lod
