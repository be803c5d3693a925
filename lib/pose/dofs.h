// Applies degrees of freedom to the nodes' local transforms (S0 3). A value of zero changes no bit.
#pragma once

#include "lib/math/trig.h"
#include "lib/model/rig.h"

namespace claque::pose
{

// Pose has turn(node, quaternion) and shift(node, vector); both act between the node's rotation and its scale. `dofs`:
// [rig.dofs.size()]; null: all at rest.
template <class Pose>
void apply_dofs(const model::Rig &rig, const float *dofs, float *weights, Pose &pose)
{
    for (size_t i = 0; i < rig.dofs.size(); ++i) {
        const model::Dof &dof = rig.dofs[i];
        const float value = dofs ? dofs[i] : dof.rest;
        if (value == 0) continue;
        if (dof.kind == model::DofKind::morph) {
            weights[rig.morph_sets[dof.node].first_weight + dof.morph_target] += value;
        } else if (dof.kind == model::DofKind::translation) {
            pose.shift(dof.node, dof.axis * value);
        } else {
            const float half = value * 0.5f, s = math::sin(half);
            pose.turn(dof.node, glm::quat(math::cos(half), dof.axis.x * s, dof.axis.y * s, dof.axis.z * s));
        }
    }
}

}  // namespace claque::pose
