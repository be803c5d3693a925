#include "lib/lod/decimate.h"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <algorithm>
#include <cmath>

#include "lib/base/error.h"
#include "lib/lod/rules.h"

namespace claque::lod
{

namespace
{

using Left = std::vector<std::array<uint32_t, 3>>;  // corners of the source

Left left_of(const Surface &surface)
{
    Left left;
    for (const Mesh::FaceHandle face : surface.mesh.all_faces()) {
        if (surface.mesh.status(face).deleted()) continue;
        std::array<uint32_t, 3> t{};
        size_t k = 0;
        for (auto v = surface.mesh.cfv_iter(face); v.is_valid() && k < 3; ++v)
            t[k++] = surface.mesh.property(surface.corners, face).of(v->idx());
        left.push_back(t);
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

double size_of(const Surface &surface)
{
    glm::dvec3 first(std::numeric_limits<double>::infinity()), last = -first;
    for (const Mesh::VertexHandle v : surface.mesh.vertices()) {
        const glm::dvec3 p = point(surface.mesh, v);
        first = glm::min(first, p), last = glm::max(last, p);
    }
    return std::max({last.x - first.x, last.y - first.y, last.z - first.z});
}

void copy_vertex(const model::Part &from, uint32_t v, model::Part &to)
{
    to.positions.push_back(from.positions[v]);
    if (!from.normals.empty()) to.normals.push_back(from.normals[v]);
    if (!from.uvs.empty()) to.uvs.push_back(from.uvs[v]);
    if (!from.colours.empty()) to.colours.push_back(from.colours[v]);
    for (uint32_t k = 0; k < from.influence_count; ++k) {
        to.joints.push_back(from.joints[size_t(v) * from.influence_count + k]);
        to.weights.push_back(from.weights[size_t(v) * from.influence_count + k]);
    }
    for (size_t m = 0; m < from.morphs.size(); ++m) {
        if (!from.morphs[m].positions.empty()) to.morphs[m].positions.push_back(from.morphs[m].positions[v]);
        if (!from.morphs[m].normals.empty()) to.morphs[m].normals.push_back(from.morphs[m].normals[v]);
    }
}

model::Part head_of(const model::Part &from)
{
    model::Part to;
    to.name = from.name, to.node = from.node, to.skinned = from.skinned, to.material = from.material;
    to.hidden = from.hidden, to.influence_count = from.influence_count, to.morph_set = from.morph_set;
    to.lod_first_m = from.lod_first_m, to.lod_last_m = from.lod_last_m;
    to.morphs.resize(from.morphs.size());
    return to;
}

// `rank` of a corner: the coarsest level that has it. Vertices of coarse levels stand first, so that a level's are the
// first of every finer one.
Decimated compact(const Surface &surface, size_t part_count, const Left &left, const std::vector<uint32_t> &rank)
{
    Decimated out;
    out.triangles = left.size();
    out.refused = surface.refused;
    for (uint32_t i = 0; i < part_count; ++i) out.parts.push_back(head_of(surface.part(i)));
    out.kept.resize(part_count);
    std::vector<uint32_t> used;
    for (const auto &t : left) used.insert(used.end(), t.begin(), t.end());
    std::sort(used.begin(), used.end(),
              [&](uint32_t a, uint32_t b) { return rank[a] != rank[b] ? rank[a] > rank[b] : a < b; });
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::vector<uint32_t> renamed(surface.corner_count(), model::none);
    for (const uint32_t corner : used) {
        model::Part &part = out.parts[surface.part_of(corner)];
        renamed[corner] = static_cast<uint32_t>(part.positions.size());
        copy_vertex(surface.part(surface.part_of(corner)), surface.vertex_of(corner), part);
        out.kept[surface.part_of(corner)].push_back(surface.vertex_of(corner));
    }
    for (const auto &t : left)
        for (const uint32_t corner : t) out.parts[surface.part_of(t[0])].indices.push_back(renamed[corner]);
    return out;
}

}  // namespace

std::vector<Decimated> decimate(const std::vector<Piece> &parts, const Decimation &wish)
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
    decimater.module(cost).use(&surface, {wish.influence * size_of(surface), wish.texture * metres_per_uv(surface), 1});
    if (!decimater.initialize()) base::fail(CLQ_ARGUMENT, "part '%s' cannot be decimated", parts[0].part->name.c_str());
    std::vector<Left> left;
    for (const size_t target : wish.targets) {
        // OpenMesh counts faces that are gone until they are collected, and its handles are what corners are kept by.
        const size_t gone = left.empty() ? 0 : surface.mesh.n_faces() - left.back().size();
        decimater.decimate_to_faces(0, target + gone);
        left.push_back(left_of(surface));
    }
    std::vector<uint32_t> rank(surface.corner_count(), 0);
    for (uint32_t level = 0; level < left.size(); ++level)
        for (const auto &t : left[level])
            for (const uint32_t corner : t) rank[corner] = level;
    std::vector<Decimated> out;
    for (const Left &level : left) out.push_back(compact(surface, parts.size(), level, rank));
    return out;
}

}  // namespace claque::lod
