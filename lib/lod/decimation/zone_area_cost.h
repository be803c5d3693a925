// Tracks the zones' area fractions while edges collapse, and adds their error to the cost of a collapse. Internal to
// lib/lod/decimation.
#pragma once

#include "lib/lod/decimation/welded_surface.h"

namespace claque::lod
{

// A level shall keep the source's area fraction of each zone (area_fractions.h). The cost of a mesh contains `weight`
// times half the square of each zone's area error, and more from half a point on. A collapse costs or gains its change
// of that.
class ZoneAreaCost
{
public:
    // `surface` is in its state before any collapse; the zones are those of `model`.
    ZoneAreaCost(const WeldedSurface &surface, const model::Model &model, double weight);

    // Updates the zone of each face and the zones' errors. To be called from time to time: costs use the last
    // measurement.
    void measure();
    // Adds the change of area of a face round the vertex to be removed.
    void change(Mesh::FaceHandle face, double area);
    // Returns the cost of all changes since the last call.
    double cost();

private:
    size_t zone_of(Mesh::FaceHandle face, glm::vec3 at) const;  // barycentric; `hole` where nothing is seen
    double slope(size_t zone) const;                            // derivative of the cost by a zone's fraction
    double measure_zones(std::vector<double> &area_fractions);  // returns the total area

    const WeldedSurface &surface_;
    const model::Model &model_;
    double weight_ = 0, area_ = 0;    // of the whole source
    std::vector<double> visibility_;  // by face (visibility.h), when rays were cast last
    size_t faces_at_cast_ = 0;
    std::vector<size_t> zones_;                              // by face
    std::vector<double> source_fractions_, area_fractions_;  // by zone
    std::vector<std::pair<size_t, double>> changes_;
};

}  // namespace claque::lod
