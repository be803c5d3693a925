// Support functions over a set of directions, under transforms and degrees of freedom (S0 3). All results are upper
// bounds: no point of the set lies farther along a direction than its value.
#pragma once

#include "lib/model/rig.h"
#include "meshsplit/reach_directions.h"

namespace claque::meshsplit
{

// One value per direction.
using Support = std::vector<double>;

// x -> turn * x + move
struct AffineMap {
    glm::dmat3 turn = glm::dmat3(1);
    glm::dvec3 move = glm::dvec3(0);
};
AffineMap after(const AffineMap &a, const AffineMap &b);  // a after b

// Enlarges `out` so that it also contains the image of `set` under `map`.
void merge(const Directions &directions, const Support &set, const AffineMap &map, Support &out);

// Returns a bound of the distance of the set's points from `centre`; see Directions::max_weight.
double farthest(const Directions &directions, const Support &set, const glm::dvec3 &centre);

// The sweep of one degree of freedom of a node over its whole range, applied to sets.
class DofSweep
{
public:
    DofSweep(const Directions &directions, const model::Dof &dof);
    // What a sweep over so many directions holds.
    static uint64_t bytes(const model::Dof &dof, size_t directions);

    // `reach`: a bound of the distance of the set's points from the node's origin.
    void sweep(double reach, Support &set, Support &scratch) const;

private:
    void plan_turns(const Directions &directions, const model::Dof &dof);

    std::vector<double> shift_;  // for a translation: added in each direction

    // For a rotation: `turned_` holds each direction in the set's frame at closely spaced angles, and `between_` bounds
    // how far points exceed the values at two neighbouring angles, as a fraction of `reach`.
    std::vector<DirectionBlend> turned_;
    std::vector<double> between_;
    size_t angles_ = 0;
};

}  // namespace claque::meshsplit
