#include "lib/lod/decimation/decimater_modules.h"

#include <algorithm>

#include "lib/math/trig.h"

namespace claque::lod
{

CornerMoves::CornerMoves(const WeldedSurface &surface, const OpenMesh::Decimater::CollapseInfoT<Mesh> &ci)
{
    const std::array<Mesh::FaceHandle, 2> faces = {ci.fl, ci.fr};
    for (size_t k = 0; k < 2; ++k) {
        if (!faces[k].is_valid()) continue;
        const Corners &corners = surface.mesh.property(surface.corners, faces[k]);
        from_[k] = surface.wedge(corners.of(ci.v0.idx()));
        onto_[k] = corners.of(ci.v1.idx());
    }
    torn_ = from_[0] == from_[1] && from_[0] != model::none && surface.wedge(onto_[0]) != surface.wedge(onto_[1]);
}

template <class MeshType>
float ModSeams<MeshType>::collapse_priority(const CollapseInfo &ci)
{
    MeshType &mesh = Base::mesh();
    if (mesh.is_boundary(ci.v0) && !mesh.is_boundary(mesh.edge_handle(ci.v0v1))) return float(Base::ILLEGAL_COLLAPSE);
    const CornerMoves moves(*surface_, ci);
    for (auto f = mesh.cvf_iter(ci.v0); f.is_valid(); ++f)
        if (moves.to(surface_->wedge(mesh.property(surface_->corners, *f).of(ci.v0.idx()))) == model::none)
            return float(Base::ILLEGAL_COLLAPSE);
    return float(Base::LEGAL_COLLAPSE);
}

template <class MeshType>
void ModFlips<MeshType>::configure(const WeldedSurface *surface, double turn_deg)
{
    surface_ = surface;
    min_cosine_ = math::cos(turn_deg * 3.14159265358979323846 / 180);
}

namespace
{

double turn(glm::vec2 a, glm::vec2 b, glm::vec2 c)
{
    const glm::dvec2 p(a), q(b), r(c);
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

// Twice the area over the square of the longest side: 0.87 at most, 0 for a needle.
double roundness(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c)
{
    const double longest = std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
    return longest > 0 ? glm::length(glm::cross(b - a, c - a)) / longest : 0;
}

constexpr double min_roundness = 0.02;

}  // namespace

template <class MeshType>
float ModFlips<MeshType>::collapse_priority(const CollapseInfo &ci)
{
    const MeshType &mesh = Base::mesh();
    const CornerMoves moves(*surface_, ci);
    const glm::dvec3 onto = point(mesh, ci.v1);
    for (auto f = mesh.cvf_iter(ci.v0); f.is_valid(); ++f) {
        if (*f == ci.fl || *f == ci.fr) continue;
        const Corners &corners = mesh.property(surface_->corners, *f);
        std::array<glm::dvec3, 3> before, after;
        std::array<glm::vec2, 3> uv_before, uv_after;
        for (size_t k = 0; k < 3; ++k) {
            const bool goes = corners.at[k] == ci.v0.idx();
            before[k] = point(mesh, typename MeshType::VertexHandle(corners.at[k]));
            after[k] = goes ? onto : before[k];
            uv_before[k] = surface_->uv(corners.corner[k]);
            uv_after[k] = uv_before[k];
            if (!goes) continue;
            const uint32_t to = moves.to(surface_->wedge(corners.corner[k]));
            if (to != model::none) uv_after[k] = surface_->uv(to);
        }
        const TriangleFrame was(before[0], before[1], before[2]), is(after[0], after[1], after[2]);
        if (!(is.area > 0)) return float(Base::ILLEGAL_COLLAPSE);
        if (was.area > 0 && glm::dot(was.normal, is.normal) < min_cosine_) return float(Base::ILLEGAL_COLLAPSE);
        const double round = roundness(after[0], after[1], after[2]);
        if (round < min_roundness && round < roundness(before[0], before[1], before[2]))
            return float(Base::ILLEGAL_COLLAPSE);
        const double turned = turn(uv_before[0], uv_before[1], uv_before[2]);
        if (turned != 0 && !(turned * turn(uv_after[0], uv_after[1], uv_after[2]) > 0))
            return float(Base::ILLEGAL_COLLAPSE);
    }
    return float(Base::LEGAL_COLLAPSE);
}

template class ModSeams<Mesh>;
template class ModFlips<Mesh>;

}  // namespace claque::lod
