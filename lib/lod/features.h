// What a vertex of a far level stands for, and what it costs to let one stand for two. Between the files of this room only.
#pragma once

#include "lib/lod/quadric.h"

namespace claque::lod
{

// The mean over the surface that has come to a vertex.
struct Features {
    double area = 0;
    Attributes mean;  // ascending by id; in metres for each 1 of difference
};

// Of both.
Features merged(const Features &a, const Features &b);

// What joining two adds to the variance of each (Ward's rule).
double variance_of(const Features &a, const Features &b);

// Where the vertex is to stand that takes the places of two at `p` and `q`: nearest to the planes of both, and not far from
// the edge, as flat regions have no best place along themselves.
glm::dvec3 optimal_position(const PlaneQuadric &planes, glm::dvec3 p, glm::dvec3 q);

// Whether a triangle turns away between the one place and the other. Those of less than `sliver` of area point anywhere.
bool flips(const TriangleFrame &was, const TriangleFrame &is, double sliver);

}  // namespace claque::lod
