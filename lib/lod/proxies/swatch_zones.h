// The zone that each triangle of a proxy shows, and the colours that it stands for. Internal to lib/lod/proxies.
#pragma once

#include <map>
#include <vector>

#include "lib/lod/proxies/proxy.h"

namespace claque::lod
{

struct ColourSum {
    glm::dvec3 colour = glm::dvec3(0);
    double area = 0;
    ColourSum &operator+=(const ColourSum &o)
    {
        colour += o.colour, area += o.area;
        return *this;
    }
    glm::dvec3 mean() const { return area > 0 ? colour / area : glm::dvec3(1); }
};
using ColourSums = std::vector<ColourSum>;  // [texture sets] in which the point shows the same zone as in the first set

inline void add(const ColourSums &from, ColourSums &to)
{
    to.resize(from.size());
    for (size_t i = 0; i < from.size(); ++i) to[i] += from[i];
}

// The colours of the source surface nearest to one triangle, by zone.
using ZoneColours = std::map<uint32_t, ColourSums>;

struct SwatchZones {
    std::vector<ZoneColours> colours;  // [triangles]
    std::vector<uint32_t> zones;       // [triangles]
};

// `tolerance`: of the zones' area fractions. Deterministic.
SwatchZones swatch_zones_of(const ProxySource &source, const model::Part &part, double tolerance);

}  // namespace claque::lod
