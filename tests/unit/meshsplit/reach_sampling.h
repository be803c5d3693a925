// A character's reach by sampling: poses of lib/pose, vertices transformed in double.
#pragma once

#include <vector>

#include "lib/base/span.h"
#include "lib/model/template.h"
#include "lib/pose/layer.h"

namespace claque::test
{

struct Sampled {
    double vertex = 0;            // the largest distance of any vertex of any level
    std::vector<double> node;     // per node: of its origin
    std::vector<double> stretch;  // per node: of its longest axis
};

// Over `count` poses: any clip, any of its times, random degrees of freedom, often at an end of their ranges.
Sampled sample_reach(const model::Template &tmpl, const glm::dvec3 &centre, uint32_t count);

// Likewise over blends of up to eight layers (S2 3.3): clips and rest pose at any times, over any part of the skeleton;
// weights of additive layers sum to at most `added`, and often to exactly that.
Sampled sample_blends(const model::Template &tmpl, const glm::dvec3 &centre, uint32_t count, float added);

// Of these layers alone, degrees of freedom at rest.
Sampled sample_layers(const model::Template &tmpl, const glm::dvec3 &centre, base::Span<const pose::Layer> layers);

}  // namespace claque::test
