// The last collapses of a surface with handles. Where arms touch hips or legs touch each other, the surface has holes.
// A mesh of dozens of triangles cannot become smaller round them while every edge has two triangles. This class merges
// any two vertices: a hole that closes leaves opposite triangles, which cancel out, or an edge with four triangles, and
// the surface stays closed. Internal to lib/lod/proxies.
#pragma once

#include "lib/lod/proxies/coarsen.h"

namespace claque::lod
{

class NonManifoldCollapse
{
public:
    // planes: [positions] the quadric of each vertex.
    NonManifoldCollapse(CoarseMesh level, std::vector<PlaneQuadric> planes, double sliver);

    // Collapses the cheapest edge first; one that flips a triangle only if all do.
    void run(size_t target);
    CoarseMesh result() const;  // without unused vertices

private:
    struct Step {
        uint32_t from = 0, to = 0;
        glm::dvec3 at = glm::dvec3(0);
        double cost = 0;
        bool flips = false;
        bool operator<(const Step &o) const { return flips != o.flips ? !flips : cost < o.cost; }
    };
    std::vector<std::vector<uint32_t>> triangles_of_vertices() const;
    Step step(uint32_t a, uint32_t b, const std::vector<std::vector<uint32_t>> &round) const;
    void apply(const Step &step);

    CoarseMesh level_;
    std::vector<PlaneQuadric> planes_;
    double sliver_ = 0;  // area below which a triangle's normal is meaningless
};

}  // namespace claque::lod
