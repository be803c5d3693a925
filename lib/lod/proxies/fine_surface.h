// The fine closed surface that coarse levels represent, as samples, with nearest-point queries. Internal to
// lib/lod/proxies.
#pragma once

#include "lib/lod/proxies/coarsen.h"
#include "lib/lod/surface/nearest.h"

namespace claque::lod
{

class FineSurface
{
public:
    // Both arguments must outlive the object; `features` [positions] as coarsen() takes them.
    FineSurface(const ClosedMesh &surface, const std::vector<Attributes> &features, size_t max_samples);

    struct Sample {
        glm::dvec3 at = glm::dvec3(0);
        double area = 0;
        const Attributes *features = nullptr;
    };
    const std::vector<Sample> &samples() const { return samples_; }
    double area() const { return area_; }
    // Returns the nearest point of the surface. `guess` is the triangle found last; successive queries are mostly close
    // to each other.
    glm::dvec3 nearest(glm::dvec3 p, uint32_t &guess) const;

private:
    const ClosedMesh &surface_;
    std::vector<Sample> samples_;
    double area_ = 0;
    NearestPoint nearest_;
};

std::vector<NearestPoint::Triangle> corners_of(const ClosedMesh &surface);
inline glm::dvec3 twice_area(const NearestPoint::Triangle &t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }

}  // namespace claque::lod
