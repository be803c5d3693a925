// Characters with degrees of freedom (S0 3), for the tests of their reach.
#pragma once

#include <string>
#include <vector>

#include "models.h"

namespace claque::test
{

struct FreeModel {
    std::string name;
    model::Model model;
};

void add_dof(model::Model &m, uint32_t node, model::DofKind kind, glm::vec3 axis, float first, float last);
// Without parts; `at` is relative to its parent.
uint32_t add_node(model::Model &m, uint32_t parent, glm::vec3 at, const char *name);
// A box in a node's frame that only this node moves.
void add_box(model::Model &m, uint32_t node, glm::vec3 centre, glm::vec3 half);

// Thirteen articulations in boxes with nineteen degrees of freedom.
FreeModel articulated_actor();
// With clips: morph targets, full rotations, cubic splines, folding, and reach that is largest between two frames.
std::vector<FreeModel> moving_models();
// Those, and one of each kind of structure: chains, slides, scaled and mirrored nodes, blends, levels.
std::vector<FreeModel> free_models();

}  // namespace claque::test
