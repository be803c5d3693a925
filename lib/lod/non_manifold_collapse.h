// The last collapses of a surface with handles. Arms that touch hips and legs that touch one another leave holes round which
// a mesh of dozens of triangles cannot get smaller and stay one whose edges have two triangles each. Here two vertices may
// become one whatever is round them: a hole that goes leaves triangles back to back, which cancel out, or an edge that four
// share, and the surface stays closed. Between the files of this room only.
#pragma once

#include "lib/lod/coarsen.h"

namespace claque::lod
{

class NonManifoldCollapse
{
public:
    // planes [positions]: what each vertex is to stay near to.
    NonManifoldCollapse(CoarseMesh level, std::vector<PlaneQuadric> planes, double sliver);

    // Cheapest edge first; one whose collapse turns a triangle over only where all do.
    void run(size_t target);
    CoarseMesh result() const;  // without vertices that no triangle has

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
    double sliver_ = 0;  // area below which a triangle points anywhere
};

}  // namespace claque::lod
