// What zones have gained or lost of the surface while edges are collapsed, and what a collapse does about it. Between the
// files of this room only.
#pragma once

#include "lib/base/services.h"
#include "lib/lod/welded_surface.h"

namespace claque::lod
{

// A level shall show of each zone as much as the source (shares.h): half the square of what its area is off by, and more
// from half a point on, times `weight`, is added to the cost of a mesh; a collapse pays or earns what it changes of that.
class ZoneAreaCost
{
public:
    // `surface` before any collapse; zones are those of `model`.
    ZoneAreaCost(const WeldedSurface &surface, const model::Model &model, double weight, const base::Jobs &jobs);

    // Which zone each face shows now, and how far zones are off. To be called from time to time: costs are those of then.
    void measure();
    // Of the faces round a vertex that is about to go: what one changes by.
    void change(Mesh::FaceHandle face, double area);
    // What all changes since the last call cost together.
    double cost();

private:
    size_t zone_of(Mesh::FaceHandle face) const;
    double slope(size_t zone) const;                            // of the cost of a zone's share
    double measure_zones(std::vector<double> &area_fractions);  // returns the area of all

    const WeldedSurface &surface_;
    const model::Model &model_;
    const base::Jobs &jobs_;
    double weight_ = 0, area_ = 0;                           // of the whole source
    std::vector<double> visibility_;                         // by face: how much of it can be (seen.h)
    std::vector<size_t> zones_;                              // by face
    std::vector<double> source_fractions_, area_fractions_;  // by zone
    std::vector<std::pair<size_t, double>> changes_;
};

}  // namespace claque::lod
