#include "lib/lod/decimation/welded_surface.h"

#include <map>
#include <set>
#include <tuple>

#include <OpenMesh/Core/System/omstream.hh>

namespace claque::lod
{

namespace
{

using PositionKey = std::tuple<float, float, float>;
using Triangles = std::vector<std::array<uint32_t, 3>>;

PositionKey position_key(glm::vec3 p) { return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; }

// The positions on edges that only one triangle of the part uses.
std::set<PositionKey> border_of(const std::vector<glm::vec3> &positions, const Triangles &triangles)
{
    std::map<std::pair<PositionKey, PositionKey>, int> count;
    for (const auto &t : triangles)
        for (size_t k = 0; k < 3; ++k) {
            PositionKey a = position_key(positions[t[k]]), b = position_key(positions[t[(k + 1) % 3]]);
            if (b < a) std::swap(a, b);
            ++count[{a, b}];
        }
    std::set<PositionKey> border;
    for (const auto &[edge, faces] : count)
        if (faces == 1) border.insert(edge.first), border.insert(edge.second);
    return border;
}

const std::vector<glm::vec3> &rest_of(const SourcePart &piece)
{
    return piece.rest ? *piece.rest : piece.part->positions;
}

// OpenMesh writes what it thinks of a mesh to stderr. The switch is one for the whole process, and several threads may
// decimate at once.
void silence_openmesh() { [[maybe_unused]] static const bool is_silent = (omerr().disable(), true); }

}  // namespace

WeldedSurface::WeldedSurface(const std::vector<SourcePart> &parts) : parts_(parts)
{
    silence_openmesh();
    first_.push_back(0);
    for (uint32_t i = 0; i < parts.size(); ++i) {
        first_.push_back(first_.back() + static_cast<uint32_t>(parts[i].part->positions.size()));
        part_of_.resize(first_.back(), i);
    }
    find_wedges();
    mesh.add_property(corners);
    mesh.request_vertex_status();
    mesh.request_edge_status();
    mesh.request_face_status();

    // Vertices weld by position and group: a part, or, after all parts, a group of sewn parts.
    std::map<std::pair<PositionKey, uint32_t>, Mesh::VertexHandle> found;
    std::vector<Triangles> triangles;
    std::vector<Mesh::VertexHandle> welded(corner_count());
    for (uint32_t i = 0; i < parts.size(); ++i) {
        triangles.push_back(model::triangles_of(*parts[i].part));
        const std::set<PositionKey> border = border_of(rest_of(parts[i]), triangles[i]);
        const uint32_t sewn = parts[i].part->skinned ? model::none : parts[i].part->node;
        for (uint32_t v = 0; v < parts[i].part->positions.size(); ++v) {
            const glm::vec3 p = rest_of(parts[i])[v];
            const PositionKey key = position_key(p);
            // Groups of parts and of nodes share one range of numbers.
            const uint32_t group = !border.count(key) ? i : static_cast<uint32_t>(parts.size()) + sewn + 1;
            const auto [at, fresh] = found.try_emplace({key, group});
            if (fresh) at->second = mesh.add_vertex({double(p.x), double(p.y), double(p.z)});
            welded[first_[i] + v] = at->second;
        }
    }
    const auto add = [this](const std::array<Mesh::VertexHandle, 3> &v, const std::array<uint32_t, 3> &corner) {
        const Mesh::FaceHandle face = mesh.add_face(v[0], v[1], v[2]);
        if (face.is_valid()) mesh.property(corners, face) = {{v[0].idx(), v[1].idx(), v[2].idx()}, corner};
        return face.is_valid();
    };
    for (uint32_t i = 0; i < parts.size(); ++i)
        for (const auto &t : triangles[i]) {
            const std::array<uint32_t, 3> corner = {first_[i] + t[0], first_[i] + t[1], first_[i] + t[2]};
            const std::array<Mesh::VertexHandle, 3> v = {welded[corner[0]], welded[corner[1]], welded[corner[2]]};
            if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0] || add(v, corner)) continue;
            std::array<Mesh::VertexHandle, 3> apart;
            for (size_t k = 0; k < 3; ++k) {
                const Mesh::Point point = mesh.point(v[k]);  // a copy: add_vertex() may move all points
                apart[k] = mesh.add_vertex(point);
                mesh.status(apart[k]).set_locked(true);
                mesh.status(v[k]).set_locked(true);
            }
            add(apart, corner);
            ++non_manifold_triangles;
        }
}

glm::vec2 WeldedSurface::uv(uint32_t corner) const
{
    const model::Part &part = *parts_[part_of_[corner]].part;
    return part.uvs.empty() ? glm::vec2(0) : part.uvs[vertex_of(corner)];
}

glm::vec3 WeldedSurface::at_rest(uint32_t corner) const { return rest_of(parts_[part_of_[corner]])[vertex_of(corner)]; }

void WeldedSurface::find_wedges()
{
    std::map<std::tuple<float, float, float, float, float, uint32_t>, uint32_t> found;
    for (uint32_t corner = 0; corner < corner_count(); ++corner) {
        const glm::vec3 p = at_rest(corner);
        const glm::vec2 t = uv(corner);
        wedge_.push_back(found.try_emplace({p.x, p.y, p.z, t.x, t.y, part_of_[corner]}, corner).first->second);
    }
}

}  // namespace claque::lod
