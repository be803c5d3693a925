#include "lib/lod/plain.h"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <limits>

#include "lib/base/error.h"
#include "lib/lod/compact.h"

namespace claque::lod
{

namespace
{

// Forbids nothing and costs nothing: it notes for each corner of a face at which vertex it stands now.
template <class MeshType>
class ModFollow : public OpenMesh::Decimater::ModBaseT<MeshType>
{
public:
    DECIMATING_MODULE(ModFollow, MeshType, Follow);
    explicit ModFollow(MeshType &mesh) : Base(mesh, true) {}
    void use(Surface *surface) { surface_ = surface; }
    void preprocess_collapse(const CollapseInfo &ci) override
    {
        MeshType &mesh = Base::mesh();
        for (auto f = mesh.vf_iter(ci.v0); f.is_valid(); ++f)
            for (int &at : mesh.property(surface_->corners, *f).at)
                if (at == ci.v0.idx()) at = ci.v1.idx();
    }

private:
    Surface *surface_ = nullptr;
};

// Which corners of the source stand at each vertex of the mesh: vertices are moved onto one another, never elsewhere.
using CornersAt = std::vector<std::vector<uint32_t>>;

CornersAt corners_at(const Surface &surface)
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

// What a corner becomes at a place.
Vertex carried(const Surface &surface, const std::vector<uint32_t> &there, uint32_t was)
{
    if (std::binary_search(there.begin(), there.end(), was)) return {was, was};
    Vertex best = {there[0], was};
    float least = std::numeric_limits<float>::infinity();
    for (const uint32_t corner : there) {
        if (surface.part_of(corner) != surface.part_of(was)) continue;
        const glm::vec2 off = surface.uv(corner) - surface.uv(was);
        const float distance = off.x * off.x + off.y * off.y;
        if (distance < least) least = distance, best = {corner, corner};
    }
    return best;
}

Left left_of(const Surface &surface, const UvSides &sides, const CornersAt &there)
{
    Left left;
    for (const Mesh::FaceHandle face : surface.mesh.all_faces()) {
        if (surface.mesh.status(face).deleted()) continue;
        const Corners &corners = surface.mesh.property(surface.corners, face);
        std::array<Vertex, 3> t;
        std::array<uint32_t, 3> looks{};
        for (size_t k = 0; k < 3; ++k) {
            t[k] = carried(surface, there[static_cast<size_t>(corners.at[k])], corners.corner[k]);
            looks[k] = t[k].look;
        }
        left.triangles.push_back(t);
        left.flipped += sides.flipped(surface, face, looks);
    }
    return left;
}

}  // namespace

std::vector<Decimated> decimated_plainly(const std::vector<Piece> &parts, const std::vector<size_t> &targets)
{
    namespace om = OpenMesh::Decimater;
    omerr().disable();
    Surface surface(parts);
    if (surface.mesh.n_faces() == 0) base::fail(CLQ_ARGUMENT, "%zu parts have no triangles to decimate", parts.size());
    if (targets.empty()) base::fail(CLQ_ARGUMENT, "a decimation has no target");
    om::DecimaterT<Mesh> decimater(surface.mesh);
    om::ModQuadricT<Mesh>::Handle quadric;
    om::ModHandleT<ModFollow<Mesh>> follow;
    decimater.add(quadric);
    decimater.add(follow);
    decimater.module(quadric).unset_max_err();
    decimater.module(follow).use(&surface);
    if (!decimater.initialize()) base::fail(CLQ_ARGUMENT, "part '%s' cannot be decimated", parts[0].part->name.c_str());
    const UvSides sides(surface);
    const CornersAt there = corners_at(surface);
    std::vector<Left> left;
    for (const size_t target : targets) {
        const size_t gone = left.empty() ? 0 : surface.mesh.n_faces() - left.back().triangles.size();
        decimater.decimate_to_faces(0, target + gone);
        left.push_back(left_of(surface, sides, there));
    }
    return compact(surface, parts.size(), left);
}

}  // namespace claque::lod
