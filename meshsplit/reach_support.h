// Support functions in a set of directions, and what transforms and degrees of freedom (S0 3) make of them. All results
// are upper bounds: no point of the set lies farther along a direction than its number says.
#pragma once

#include "lib/model/rig.h"
#include "meshsplit/reach_directions.h"

namespace claque::meshsplit
{

// One number a direction.
using Support = std::vector<double>;

// x -> turn * x + move
struct AffineMap {
    glm::dmat3 turn = glm::dmat3(1);
    glm::dvec3 move = glm::dvec3(0);
};
AffineMap after(const AffineMap &a, const AffineMap &b);  // a after b

// `out` takes in what `map` makes of `set` too.
void merge(const Directions &directions, const Support &set, const AffineMap &map, Support &out);

// No point of the set is farther from `centre`; see Directions::most_weight.
double farthest(const Directions &directions, const Support &set, const glm::dvec3 &centre);

// What one degree of freedom of a node makes of a set, over its whole range.
class DofSweep
{
public:
    DofSweep(const Directions &directions, const model::Dof &dof);
    // No point of the set is farther from the node's origin than `reach`.
    void sweep(double reach, Support &set, Support &scratch) const;

private:
    void plan_turns(const Directions &directions, const model::Dof &dof);

    std::vector<double> shift_;  // of a translation: added in each direction
    // Of a rotation: for each direction, as the set sees it at angles close enough to each other,
    std::vector<DirectionBlend> turned_;  // and what points may stand out between two of them, as a share of `reach`.
    std::vector<double> between_;
    size_t angles_ = 0;
};

}  // namespace claque::meshsplit
