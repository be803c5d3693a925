// The attributes that a vertex of a proxy represents, and the cost of merging two vertices. Internal to
// lib/lod/proxies.
#pragma once

#include "lib/lod/surface/quadric.h"

namespace claque::lod
{

// The mean over the surface that a vertex represents.
struct Features {
    double area = 0;
    Attributes mean;  // ascending by id; in metres per unit of difference
};

// The features of a vertex that represents both.
Features merged(const Features &a, const Features &b);

// Returns what a merge adds to the variance of the features (Ward's rule).
double variance_of(const Features &a, const Features &b);

// Returns the position of the vertex that replaces two at `p` and `q`: closest to the planes of both, but not far from
// the edge, because flat regions have no unique minimum.
glm::dvec3 optimal_position(const PlaneQuadric &planes, glm::dvec3 p, glm::dvec3 q);

// Returns whether a triangle's normal flips. Triangles with an area below `sliver` never do: their normals are
// meaningless.
bool flips(const TriangleFrame &was, const TriangleFrame &is, double sliver);

}  // namespace claque::lod
