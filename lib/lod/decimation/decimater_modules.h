// The rules of a collapse, as modules of OpenMesh's decimater. Internal to lib/lod/decimation.
#pragma once

#include <OpenMesh/Tools/Decimater/ModBaseT.hh>

#include "lib/lod/decimation/zone_area_cost.h"

namespace claque::lod
{

// Maps a wedge at the removed vertex to the corner at the vertex that stays, by the two triangles that vanish. A wedge
// that is in neither of them has no target.
class CornerMoves
{
public:
    CornerMoves(const WeldedSurface &surface, const OpenMesh::Decimater::CollapseInfoT<Mesh> &ci);
    uint32_t to(uint32_t wedge) const
    {
        if (torn_) return model::none;
        return wedge == from_[0] ? onto_[0] : wedge == from_[1] ? onto_[1] : model::none;
    }

private:
    std::array<uint32_t, 2> from_{model::none, model::none}, onto_{model::none, model::none};
    bool torn_ = false;
};

// Keeps seams closed: every wedge of the removed vertex must have a partner at the end that stays. Open borders
// collapse only along themselves.
template <class MeshType>
class ModSeams : public OpenMesh::Decimater::ModBaseT<MeshType>
{
public:
    DECIMATING_MODULE(ModSeams, MeshType, Seams);
    explicit ModSeams(MeshType &mesh) : Base(mesh, true) {}
    void configure(const WeldedSurface *surface) { surface_ = surface; }
    float collapse_priority(const CollapseInfo &ci) override;

private:
    const WeldedSurface *surface_ = nullptr;
};

// Forbids collapses that flip a triangle, in space or in its texture, or that make a new needle.
template <class MeshType>
class ModFlips : public OpenMesh::Decimater::ModBaseT<MeshType>
{
public:
    DECIMATING_MODULE(ModFlips, MeshType, Flips);
    explicit ModFlips(MeshType &mesh) : Base(mesh, true) {}
    void configure(const WeldedSurface *surface, double turn_deg);
    float collapse_priority(const CollapseInfo &ci) override;

private:
    const WeldedSurface *surface_ = nullptr;
    double min_cosine_ = 0.5;
};

// The weights of attributes, in metres per unit of difference.
struct Weights {
    std::vector<double> influences;  // [palette] of a whole influence that moves to another joint
    double texture = 0;              // of 1 unit of u or v
    double border = 1;               // of seams and open edges, relative to the surface
    double area = 1;                 // of the square of the area that a collapse removes or adds
};

// Computes the cost of a collapse (quadric.h). It also moves the corners of faces, after their attributes have been
// added up.
template <class MeshType>
class ModCost : public OpenMesh::Decimater::ModBaseT<MeshType>
{
public:
    DECIMATING_MODULE(ModCost, MeshType, Cost);
    explicit ModCost(MeshType &mesh) : Base(mesh, false) {}
    void configure(WeldedSurface *surface, const Weights &weights, ZoneAreaCost *zone_area);  // zone_area may be null
    void initialize() override;
    float collapse_priority(const CollapseInfo &ci) override;
    void preprocess_collapse(const CollapseInfo &ci) override;

private:
    Attributes attributes_of(uint32_t corner) const;
    void add_borders();
    double area_change(const CollapseInfo &ci);

    WeldedSurface *surface_ = nullptr;
    Weights weights_;
    ZoneAreaCost *zone_area_ = nullptr;
    std::vector<PlaneQuadric> planes_;          // by vertex
    std::vector<AttributeQuadric> attributes_;  // by wedge
    std::vector<Attributes> carried_;           // by corner
};

extern template class ModSeams<Mesh>;
extern template class ModFlips<Mesh>;
extern template class ModCost<Mesh>;

}  // namespace claque::lod
