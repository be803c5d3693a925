// The closed surface of a part of a posed character, and how deep points lie in it, in double precision.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include <glm/vec2.hpp>

#include "puppet.h"

namespace puppet
{

using glm::dvec3;

class Surface
{
public:
    // The triangles whose corners all pass `own` (by vertex). Seams are welded, and each hole that remains is closed by
    // a fan round its centre.
    Surface(const Model &figure, const std::function<bool(size_t vertex)> &own);

    // Moves the surface to these vertices of the whole figure.
    void pose(const std::vector<vec3> &vertices);

    // Distance to the nearest place of the outer surface; 0 outside. Pieces may overlap: what lies inside of another
    // piece is not outer.
    double depth(dvec3 p) const;

    size_t triangle_count() const { return triangles_.size(); }
    const std::vector<uint32_t> &welded() const { return welded_; }

private:
    struct Hole {
        std::vector<uint32_t> rim;
        uint32_t centre;
    };
    void close_holes(const Model &figure);
    int winding(dvec3 p) const;
    dvec3 nearest(size_t triangle, dvec3 p) const;

    std::vector<uint32_t> welded_;  // per vertex: the first at its place
    std::vector<std::array<uint32_t, 3>> triangles_;
    std::vector<Hole> holes_;
    std::vector<dvec3> points_, turned_;  // turned: along the ray of winding()
};

}  // namespace puppet
