#include "lib/lod/decimate.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <map>
#include <tuple>

#include "lib/base/error.h"

namespace claque::lod
{

namespace
{

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using Welded = OpenMesh::TriMesh_ArrayKernelT<Traits>;

// Which vertex of the part stands at each corner of a face; kept by welded vertex, so that it does not matter how the
// mesh re-uses its halfedges.
struct Corners {
    std::array<int, 3> at{};
    std::array<uint32_t, 3> vertex{};

    uint32_t of(int welded) const
    {
        for (size_t k = 0; k < 3; ++k)
            if (at[k] == welded) return vertex[k];
        return model::none;
    }
};
using CornerProperty = OpenMesh::FPropHandleT<Corners>;

// The rule about seams: see the header. A vertex of the part may go only if one of the two triangles that vanish shows
// where its side of the surface continues.
template <class MeshType>
class ModSeams : public OpenMesh::Decimater::ModBaseT<MeshType>
{
public:
    DECIMATING_MODULE(ModSeams, MeshType, Seams);

    explicit ModSeams(Mesh &mesh) : Base(mesh, true) {}
    void use(CornerProperty corners, const std::vector<uint32_t> *side)
    {
        corners_ = corners;
        side_ = side;
    }

    float collapse_priority(const CollapseInfo &ci) override
    {
        Mesh &mesh = Base::mesh();
        if (mesh.is_boundary(ci.v0) && !mesh.is_boundary(mesh.edge_handle(ci.v0v1))) return illegal();
        const Moves moves = moves_of(ci);
        for (auto f = mesh.cvf_iter(ci.v0); f.is_valid(); ++f)
            if (moves.to(side(mesh.property(corners_, *f).of(ci.v0.idx()))) == model::none) return illegal();
        return float(Base::LEGAL_COLLAPSE);
    }

    void preprocess_collapse(const CollapseInfo &ci) override
    {
        Mesh &mesh = Base::mesh();
        const Moves moves = moves_of(ci);
        for (auto f = mesh.vf_iter(ci.v0); f.is_valid(); ++f) {
            Corners &corners = mesh.property(corners_, *f);
            for (size_t k = 0; k < 3; ++k)
                if (corners.at[k] == ci.v0.idx()) {
                    corners.vertex[k] = moves.to(side(corners.vertex[k]));
                    corners.at[k] = ci.v1.idx();
                    break;
                }
        }
    }

private:
    // From a side at the vertex that goes to the part's vertex at the one that stays.
    struct Moves {
        std::array<uint32_t, 2> from{model::none, model::none}, onto{model::none, model::none};
        bool torn = false;

        uint32_t to(uint32_t id) const
        {
            if (torn) return model::none;
            return id == from[0] ? onto[0] : id == from[1] ? onto[1] : model::none;
        }
    };

    static float illegal() { return float(Base::ILLEGAL_COLLAPSE); }
    uint32_t side(uint32_t vertex) const { return (*side_)[vertex]; }

    Moves moves_of(const CollapseInfo &ci)
    {
        Moves moves;
        const std::array<typename Mesh::FaceHandle, 2> faces = {ci.fl, ci.fr};
        for (size_t k = 0; k < 2; ++k) {
            if (!faces[k].is_valid()) continue;
            const Corners &corners = Base::mesh().property(corners_, faces[k]);
            moves.from[k] = side(corners.of(ci.v0.idx()));
            moves.onto[k] = corners.of(ci.v1.idx());
        }
        moves.torn = moves.from[0] == moves.from[1] && moves.from[0] != model::none &&
                     side(moves.onto[0]) != side(moves.onto[1]);
        return moves;
    }

    CornerProperty corners_;
    const std::vector<uint32_t> *side_ = nullptr;
};

// Vertices that differ only in their normals count as one side of the surface.
std::vector<uint32_t> sides_of(const model::Part &part)
{
    std::map<std::tuple<float, float, float, float, float>, uint32_t> found;
    std::vector<uint32_t> sides;
    for (uint32_t v = 0; v < part.positions.size(); ++v) {
        const glm::vec3 p = part.positions[v];
        const glm::vec2 uv = part.uvs.empty() ? glm::vec2(0) : part.uvs[v];
        sides.push_back(found.try_emplace({p.x, p.y, p.z, uv.x, uv.y}, v).first->second);
    }
    return sides;
}

class Builder
{
public:
    explicit Builder(const model::Part &part) : part_(part), sides_(sides_of(part))
    {
        mesh_.add_property(corners_);
        std::map<std::tuple<float, float, float>, Welded::VertexHandle> found;
        for (const glm::vec3 p : part.positions) {
            const auto [at, fresh] = found.try_emplace({p.x, p.y, p.z});
            if (fresh) at->second = mesh_.add_vertex({double(p.x), double(p.y), double(p.z)});
            welded_.push_back(at->second);
        }
        for (const auto &t : model::triangles_of(part)) {
            const std::array<Welded::VertexHandle, 3> v = {welded_[t[0]], welded_[t[1]], welded_[t[2]]};
            if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
            const Welded::FaceHandle face = mesh_.add_face(v[0], v[1], v[2]);
            if (face.is_valid()) mesh_.property(corners_, face) = {{v[0].idx(), v[1].idx(), v[2].idx()}, t};
            else refused_.push_back(t);
        }
    }

    Decimated run(const Decimation &wish)
    {
        namespace om = OpenMesh::Decimater;
        om::DecimaterT<Welded> decimater(mesh_);
        om::ModQuadricT<Welded>::Handle quadric;
        om::ModNormalFlippingT<Welded>::Handle flipping;
        ModSeams<Welded>::Handle seams;
        decimater.add(quadric);
        decimater.add(flipping);
        decimater.add(seams);
        decimater.module(quadric).unset_max_err();
        decimater.module(flipping).set_max_normal_deviation(double(wish.normal_turn_deg));
        decimater.module(seams).use(corners_, &sides_);
        mesh_.request_face_normals();
        mesh_.update_face_normals();
        if (!decimater.initialize()) base::fail(CLQ_ARGUMENT, "part '%s' cannot be decimated", part_.name.c_str());
        const size_t kept = wish.target_triangles > refused_.size() ? wish.target_triangles - refused_.size() : 0;
        decimater.decimate_to_faces(0, kept);
        std::vector<std::array<uint32_t, 3>> left;
        for (const Welded::FaceHandle face : mesh_.faces()) {
            if (mesh_.status(face).deleted()) continue;
            std::array<uint32_t, 3> t{};
            size_t k = 0;
            for (auto v = mesh_.cfv_iter(face); v.is_valid() && k < 3; ++v)
                t[k++] = mesh_.property(corners_, face).of(v->idx());
            left.push_back(t);
        }
        left.insert(left.end(), refused_.begin(), refused_.end());
        return compact(left);
    }

private:
    Decimated compact(const std::vector<std::array<uint32_t, 3>> &triangles) const
    {
        Decimated out;
        out.triangles = triangles.size();
        out.refused = refused_.size();
        model::Part &part = out.part;
        part.name = part_.name, part.node = part_.node, part.skinned = part_.skinned, part.material = part_.material;
        part.hidden = part_.hidden, part.influence_count = part_.influence_count;
        std::vector<uint32_t> renamed(part_.positions.size(), model::none);
        for (const auto &t : triangles)
            for (const uint32_t v : t) {
                if (renamed[v] == model::none) {
                    renamed[v] = static_cast<uint32_t>(part.positions.size());
                    copy_vertex(v, part);
                }
                part.indices.push_back(renamed[v]);
            }
        return out;
    }

    void copy_vertex(uint32_t v, model::Part &to) const
    {
        to.positions.push_back(part_.positions[v]);
        if (!part_.normals.empty()) to.normals.push_back(part_.normals[v]);
        if (!part_.uvs.empty()) to.uvs.push_back(part_.uvs[v]);
        if (!part_.colours.empty()) to.colours.push_back(part_.colours[v]);
        for (uint32_t k = 0; k < part_.influence_count; ++k) {
            to.joints.push_back(part_.joints[size_t(v) * part_.influence_count + k]);
            to.weights.push_back(part_.weights[size_t(v) * part_.influence_count + k]);
        }
    }

    const model::Part &part_;
    std::vector<uint32_t> sides_;
    Welded mesh_;
    CornerProperty corners_;
    std::vector<Welded::VertexHandle> welded_;
    std::vector<std::array<uint32_t, 3>> refused_;
};

}  // namespace

Decimated decimate(const model::Part &part, const Decimation &wish)
{
    if (!part.morphs.empty()) base::fail(CLQ_ARGUMENT, "part '%s' has morph targets: not decimated", part.name.c_str());
    if (model::triangles_of(part).empty()) base::fail(CLQ_ARGUMENT, "part '%s' has no triangles", part.name.c_str());
    omerr().disable();
    return Builder(part).run(wish);
}

}  // namespace claque::lod
