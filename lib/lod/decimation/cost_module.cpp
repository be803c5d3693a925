// ModCost: the cost of a collapse (decimater_modules.h).
#include <algorithm>
#include <cmath>

#include "lib/lod/decimation/decimater_modules.h"

namespace claque::lod
{

namespace
{

// The zone term can lower the cost of a collapse to this fraction at most.
constexpr double min_cost_fraction = 0.75;
constexpr uint32_t number_of_u = 0, number_of_v = 1, first_joint = 2;

}  // namespace

template <class MeshType>
void ModCost<MeshType>::configure(WeldedSurface *surface, const Weights &weights, ZoneAreaCost *zone_area)
{
    surface_ = surface;
    weights_ = weights;
    zone_area_ = zone_area;
}

template <class MeshType>
Attributes ModCost<MeshType>::attributes_of(uint32_t corner) const
{
    Attributes out;
    const model::Part &part = surface_->part(surface_->part_of(corner));
    const uint32_t v = surface_->vertex_of(corner);
    if (!part.uvs.empty() && weights_.texture > 0) {
        out.push_back({number_of_u, weights_.texture * double(part.uvs[v].x)});
        out.push_back({number_of_v, weights_.texture * double(part.uvs[v].y)});
    }
    for (uint32_t k = 0; k < part.influence_count; ++k) {
        const size_t i = size_t(v) * part.influence_count + k;
        if (part.weights[i] == 0 || !(weights_.influences[part.joints[i]] > 0)) continue;
        const uint32_t id = first_joint + part.joints[i];
        const double value = weights_.influences[part.joints[i]] * double(part.weights[i]);
        const auto same = std::find_if(out.begin(), out.end(), [id](const Attribute &a) { return a.id == id; });
        if (same != out.end()) same->value += value;
        else out.push_back({id, value});
    }
    std::sort(out.begin(), out.end(), [](const Attribute &a, const Attribute &b) { return a.id < b.id; });
    return out;
}

template <class MeshType>
void ModCost<MeshType>::initialize()
{
    const MeshType &mesh = Base::mesh();
    planes_.assign(mesh.n_vertices(), PlaneQuadric());
    attributes_.assign(surface_->corner_count(), AttributeQuadric());
    carried_.clear();
    for (uint32_t corner = 0; corner < surface_->corner_count(); ++corner) carried_.push_back(attributes_of(corner));
    for (const auto face : mesh.faces()) {
        const Corners &corners = mesh.property(surface_->corners, face);
        std::array<glm::dvec3, 3> p;
        for (size_t k = 0; k < 3; ++k) p[k] = point(mesh, typename MeshType::VertexHandle(corners.at[k]));
        const TriangleFrame frame(p[0], p[1], p[2]);
        if (!(frame.area > 0)) continue;
        for (size_t k = 0; k < 3; ++k) {
            planes_[static_cast<size_t>(corners.at[k])].add_plane(frame.normal, frame.origin, frame.area);
            attributes_[surface_->wedge(corners.corner[k])].add_triangle(
                frame, carried_[corners.corner[0]], carried_[corners.corner[1]], carried_[corners.corner[2]]);
        }
    }
    add_borders();
}

// Adds planes through open edges and through edges whose two sides have different corners, perpendicular to the
// surface. They make it expensive to bend a line on the surface.
template <class MeshType>
void ModCost<MeshType>::add_borders()
{
    const MeshType &mesh = Base::mesh();
    for (const auto edge : mesh.edges()) {
        const auto h = mesh.halfedge_handle(edge, 0);
        const auto from = mesh.from_vertex_handle(h), to = mesh.to_vertex_handle(h);
        const std::array<typename MeshType::FaceHandle, 2> faces = {mesh.face_handle(h), mesh.opposite_face_handle(h)};
        if (faces[0].is_valid() && faces[1].is_valid()) {
            const Corners &a = mesh.property(surface_->corners, faces[0]),
                          &b = mesh.property(surface_->corners, faces[1]);
            if (surface_->wedge(a.of(from.idx())) == surface_->wedge(b.of(from.idx())) &&
                surface_->wedge(a.of(to.idx())) == surface_->wedge(b.of(to.idx())))
                continue;
        }
        const glm::dvec3 p = point(mesh, from), along = point(mesh, to) - p;
        for (const auto face : faces) {
            if (!face.is_valid()) continue;
            const Corners &corners = mesh.property(surface_->corners, face);
            std::array<glm::dvec3, 3> q;
            for (size_t k = 0; k < 3; ++k) q[k] = point(mesh, typename MeshType::VertexHandle(corners.at[k]));
            const TriangleFrame frame(q[0], q[1], q[2]);
            const glm::dvec3 across = glm::cross(frame.normal, along);
            const double length = glm::length(across);
            if (!(frame.area > 0) || !(length > 0)) continue;
            const double weight = weights_.border * glm::dot(along, along);
            planes_[static_cast<size_t>(from.idx())].add_plane(across / length, p, weight);
            planes_[static_cast<size_t>(to.idx())].add_plane(across / length, p, weight);
        }
    }
}

// Returns the change of area of the triangles round the removed vertex, including the two that vanish.
template <class MeshType>
double ModCost<MeshType>::area_change(const CollapseInfo &ci)
{
    const MeshType &mesh = Base::mesh();
    double change = 0;
    for (auto f = mesh.cvf_iter(ci.v0); f.is_valid(); ++f) {
        const Corners &corners = mesh.property(surface_->corners, *f);
        std::array<glm::dvec3, 3> before, after;
        for (size_t k = 0; k < 3; ++k) {
            before[k] = point(mesh, typename MeshType::VertexHandle(corners.at[k]));
            after[k] = corners.at[k] == ci.v0.idx() ? point(mesh, ci.v1) : before[k];
        }
        const double more =
            TriangleFrame(after[0], after[1], after[2]).area - TriangleFrame(before[0], before[1], before[2]).area;
        if (zone_area_) zone_area_->change(*f, more);
        change += more;
    }
    return change;
}

template <class MeshType>
float ModCost<MeshType>::collapse_priority(const CollapseInfo &ci)
{
    const MeshType &mesh = Base::mesh();
    const glm::dvec3 onto = point(mesh, ci.v1);
    double cost =
        planes_[static_cast<size_t>(ci.v0.idx())].at(onto) + planes_[static_cast<size_t>(ci.v1.idx())].at(onto);
    const CornerMoves moves(*surface_, ci);
    uint32_t visited[2] = {model::none, model::none};
    for (auto f = mesh.cvf_iter(ci.v0); f.is_valid(); ++f) {
        const uint32_t wedge = surface_->wedge(mesh.property(surface_->corners, *f).of(ci.v0.idx()));
        if (wedge == visited[0] || wedge == visited[1]) continue;
        const uint32_t to = moves.to(wedge);
        if (to == model::none) return float(Base::ILLEGAL_COLLAPSE);
        visited[visited[0] == model::none ? 0 : 1] = wedge;
        cost += attributes_[wedge].at(onto, carried_[to]);
    }
    const double lost = area_change(ci);
    cost += weights_.area * lost * lost;
    // A collapse that corrects zones is cheaper, but bending the surface is never free.
    if (zone_area_) cost = std::max(cost + zone_area_->cost(), min_cost_fraction * cost);
    return static_cast<float>(std::max(cost, 0.0));
}

template <class MeshType>
void ModCost<MeshType>::preprocess_collapse(const CollapseInfo &ci)
{
    MeshType &mesh = Base::mesh();
    planes_[static_cast<size_t>(ci.v1.idx())] += planes_[static_cast<size_t>(ci.v0.idx())];
    const CornerMoves moves(*surface_, ci);
    uint32_t visited[2] = {model::none, model::none};
    for (auto f = mesh.vf_iter(ci.v0); f.is_valid(); ++f) {
        Corners &corners = mesh.property(surface_->corners, *f);
        const uint32_t wedge = surface_->wedge(corners.of(ci.v0.idx())), to = moves.to(wedge);
        if (wedge != visited[0] && wedge != visited[1]) {
            visited[visited[0] == model::none ? 0 : 1] = wedge;
            attributes_[surface_->wedge(to)] += attributes_[wedge];
        }
        for (size_t k = 0; k < 3; ++k)
            if (corners.at[k] == ci.v0.idx()) {
                corners.corner[k] = to;
                corners.at[k] = ci.v1.idx();
                break;
            }
    }
}

template class ModCost<Mesh>;

}  // namespace claque::lod
