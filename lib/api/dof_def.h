// Converts a host's degree of freedom to a Model's, for templates and for assets.
#pragma once

#include <claque/template.h>

#include "lib/api/boundary.h"
#include "lib/model/model.h"

namespace claque::api
{

inline uint32_t morph_set_of(const model::Rig &rig, uint32_t node, uint32_t dof)
{
    for (uint32_t i = 0; i < rig.morph_sets.size(); ++i)
        if (rig.morph_sets[i].node == node) return i;
    base::fail(CLQ_ARGUMENT, "degree of freedom %u is of a morph target of node %u, which has no morphed part", dof,
               node);
}

// Of `node`, whatever def.node is; `index` is for messages. Throws base::Error (CLQ_ARGUMENT).
inline model::Dof dof_of(const clq_dof_def &def, const model::Rig &rig, uint32_t node, uint32_t index)
{
    if (number_of(def.kind) > 2)
        base::fail(CLQ_ARGUMENT, "degree of freedom %u '%s' has an unknown kind", index, name_of(def.name));
    model::Dof made;
    made.kind = static_cast<model::DofKind>(def.kind);
    made.node = def.kind == CLQ_DOF_MORPH ? morph_set_of(rig, node, index) : node;
    made.morph_target = def.morph_target;
    if (def.kind != CLQ_DOF_MORPH) made.axis = glm::vec3(def.axis[0], def.axis[1], def.axis[2]);
    made.min = def.min, made.max = def.max, made.rest = def.rest;
    return made;
}

}  // namespace claque::api
