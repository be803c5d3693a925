// Reads nodes, joints and degrees of freedom from a host's own arrays (S0 3).
#include <limits>

#include "lib/api/boundary.h"
#include "lib/api/dof_def.h"
#include "lib/api/template_parts.h"

namespace claque::api
{

namespace
{

bool all_zero(const float *values, int count)
{
    for (int i = 0; i < count; ++i)
        if (values[i] != 0) return false;
    return true;
}

}  // namespace

void add_nodes(const clq_template_def &def, model::Model &model)
{
    require_array(def.nodes, def.node_count, "nodes");
    for (uint32_t i = 0; i < def.node_count; ++i) {
        const clq_node_def &node = def.nodes[i];
        math::Trs trs;
        trs.translation = glm::vec3(node.translation[0], node.translation[1], node.translation[2]);
        const float *q = node.rotation_xyzw;
        if (!all_zero(q, 4)) trs.rotation = glm::quat(q[3], q[0], q[1], q[2]);
        if (!all_zero(node.scale, 3)) trs.scale = glm::vec3(node.scale[0], node.scale[1], node.scale[2]);
        model.rig.parents.push_back(node.parent);
        model.rig.rest.push_back(trs);
        model.rig.node_names.emplace_back(name_of(node.name));
        model.rig.deactivation_m.push_back(node.deactivation_m != 0 ? node.deactivation_m
                                                                    : std::numeric_limits<float>::infinity());
    }
}

void add_joints(const clq_template_def &def, model::Model &model)
{
    require_array(def.joints, def.joint_count, "joints");
    for (uint32_t i = 0; i < def.joint_count; ++i) {
        model::PaletteEntry entry;
        entry.node = def.joints[i].node;
        if (const float *m = def.joints[i].inverse_bind)
            for (int k = 0; k < 4; ++k)
                entry.inverse_bind.set_column(k, glm::vec3(m[4 * k], m[4 * k + 1], m[4 * k + 2]));
        model.rig.palette.push_back(entry);
    }
}

void add_dofs(const clq_template_def &def, model::Model &model)
{
    require_array(def.dofs, def.dof_count, "degrees of freedom");
    for (uint32_t i = 0; i < def.dof_count; ++i) {
        const clq_dof_def &dof = def.dofs[i];
        model.rig.dofs.push_back(dof_of(dof, model.rig, dof.node, i));
        model.rig.dof_names.emplace_back(name_of(dof.name));
    }
}

}  // namespace claque::api
