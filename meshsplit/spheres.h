// The Sklsroot Bsphere: static, big enough for every pose of every clip. S0 4.1 set its radius by hand; here it is
// found from the clips, the degrees of freedom and the mesh.
#pragma once

#include "lib/model/template.h"

namespace claque::meshsplit
{

// Holds every vertex of every level at rest and in every pose of every clip, with every degree of freedom anywhere in its
// range (reach.h), in the actor's own space. Poses are taken at all key times and at least 60 times a second between
// them; what a vertex can bulge out between two poses is added.
model::Sphere enclosing_sphere(const model::Template &tmpl);

// The times at which a clip is looked at, ascending. Before the keys of STEP channels the last moment of the old value
// is one of them.
std::vector<double> sample_times(const model::Rig &rig, uint32_t clip);

}  // namespace claque::meshsplit
