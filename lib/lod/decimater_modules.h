// The rules of a collapse, as modules of OpenMesh's decimater. Between the files of this room only.
#pragma once

#include <OpenMesh/Tools/Decimater/ModBaseT.hh>

#include "lib/lod/zone_area_cost.h"

namespace claque::lod
{

// From a corner's side at the vertex that goes to the corner at the one that stays, as the two triangles that vanish
// show it. A side that they do not show has nowhere to go.
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

// Seams stay shut: every side of the vertex that goes has a partner at the end that stays, and open borders are
// collapsed only along themselves.
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

// No triangle turns over, on the surface or in its texture, and none becomes a needle that was not one.
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

// What carries over from triangle to triangle and how much it counts, in metres for each 1 of difference.
struct Weights {
    std::vector<double> influences;  // [palette] a whole influence that another joint takes
    double texture = 0;              // 1 of u or v
    double border = 1;               // seams and open edges against the surface itself
    double area = 1;                 // the square of what a collapse takes from the surface or adds to it
};

// The cost of a collapse: lib/lod/quadric.h. It also moves the corners of faces, after what they carry has been added up.
template <class MeshType>
class ModCost : public OpenMesh::Decimater::ModBaseT<MeshType>
{
public:
    DECIMATING_MODULE(ModCost, MeshType, Cost);
    explicit ModCost(MeshType &mesh) : Base(mesh, false) {}
    void configure(WeldedSurface *surface, const Weights &weights, ZoneAreaCost *zone_area);  // null: none
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
    std::vector<AttributeQuadric> attributes_;  // by side
    std::vector<Attributes> carried_;           // by corner
};

extern template class ModSeams<Mesh>;
extern template class ModFlips<Mesh>;
extern template class ModCost<Mesh>;

}  // namespace claque::lod
