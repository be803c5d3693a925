// decimate_quadric_only (decimate.h).
#include <algorithm>
#include <limits>

#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "lib/base/error.h"
#include "lib/lod/decimation/add_module.h"
#include "lib/lod/decimation/decimate.h"
#include "lib/lod/decimation/decimated_parts.h"

namespace claque::lod
{

namespace
{

// Allows everything at no cost; it tracks at which vertex each face corner stands.
template <class MeshType>
class ModFollow : public OpenMesh::Decimater::ModBaseT<MeshType>
{
public:
    DECIMATING_MODULE(ModFollow, MeshType, Follow);
    explicit ModFollow(MeshType &mesh) : Base(mesh, true) {}
    void configure(WeldedSurface *surface) { surface_ = surface; }
    void preprocess_collapse(const CollapseInfo &ci) override
    {
        MeshType &mesh = Base::mesh();
        for (auto f = mesh.vf_iter(ci.v0); f.is_valid(); ++f)
            for (int &at : mesh.property(surface_->corners, *f).at)
                if (at == ci.v0.idx()) at = ci.v1.idx();
    }

private:
    WeldedSurface *surface_ = nullptr;
};

// The corners of the source at each vertex of the mesh. Vertices only move onto one another.
using CornersAt = std::vector<std::vector<uint32_t>>;

CornersAt corners_at(const WeldedSurface &surface)
{
    CornersAt found(surface.mesh.n_vertices());
    for (const Mesh::FaceHandle face : surface.mesh.faces()) {
        const Corners &corners = surface.mesh.property(surface.corners, face);
        for (size_t k = 0; k < 3; ++k) found[static_cast<size_t>(corners.at[k])].push_back(corners.corner[k]);
    }
    for (std::vector<uint32_t> &one : found) {
        std::sort(one.begin(), one.end());
        one.erase(std::unique(one.begin(), one.end()), one.end());
    }
    return found;
}

// Returns the vertex that a corner becomes at a new position.
LevelVertex carried(const WeldedSurface &surface, const std::vector<uint32_t> &there, uint32_t was)
{
    if (std::binary_search(there.begin(), there.end(), was)) return {was, was};
    LevelVertex best = {there[0], was};
    float least = std::numeric_limits<float>::infinity();
    for (const uint32_t corner : there) {
        if (surface.part_of(corner) != surface.part_of(was)) continue;
        const glm::vec2 off = surface.uv(corner) - surface.uv(was);
        const float distance = off.x * off.x + off.y * off.y;
        if (distance < least) least = distance, best = {corner, corner};
    }
    return best;
}

LevelTriangles level_triangles(const WeldedSurface &surface, const UvOrientations &orientations, const CornersAt &there)
{
    LevelTriangles remaining;
    for (const Mesh::FaceHandle face : surface.mesh.all_faces()) {
        if (surface.mesh.status(face).deleted()) continue;
        const Corners &corners = surface.mesh.property(surface.corners, face);
        std::array<LevelVertex, 3> t;
        std::array<uint32_t, 3> attribute_corners{};
        for (size_t k = 0; k < 3; ++k) {
            t[k] = carried(surface, there[static_cast<size_t>(corners.at[k])], corners.corner[k]);
            attribute_corners[k] = t[k].attribute_corner;
        }
        remaining.triangles.push_back(t);
        remaining.flipped += orientations.flipped(surface, face, attribute_corners);
    }
    return remaining;
}

}  // namespace

std::vector<Decimated> decimate_quadric_only(const std::vector<SourcePart> &parts, const std::vector<size_t> &targets)
{
    namespace om = OpenMesh::Decimater;
    WeldedSurface surface(parts);
    if (surface.mesh.n_faces() == 0) base::fail(CLQ_ARGUMENT, "%zu parts have no triangles to decimate", parts.size());
    if (targets.empty()) base::fail(CLQ_ARGUMENT, "a decimation has no target");
    om::DecimaterT<Mesh> decimater(surface.mesh);
    om::ModQuadricT<Mesh>::Handle quadric;
    om::ModHandleT<ModFollow<Mesh>> follow;
    add_module(decimater, quadric);
    add_module(decimater, follow);
    decimater.module(quadric).unset_max_err();
    decimater.module(follow).configure(&surface);
    if (!decimater.initialize()) base::fail(CLQ_ARGUMENT, "part '%s' cannot be decimated", parts[0].part->name.c_str());
    const UvOrientations orientations(surface);
    const CornersAt there = corners_at(surface);
    std::vector<LevelTriangles> remaining;
    for (const size_t target : targets) {
        const size_t gone = remaining.empty() ? 0 : surface.mesh.n_faces() - remaining.back().triangles.size();
        decimater.decimate_to_faces(0, target + gone);
        remaining.push_back(level_triangles(surface, orientations, there));
    }
    return build_decimated(surface, parts.size(), remaining);
}

}  // namespace claque::lod
