// The Skeleton nodes of a flyer and their degrees of freedom (S0 3).
#include "lib/figures/flyer/axes.h"
#include "lib/figures/flyer/flyer.h"

namespace claque::figures::flyer
{

namespace
{

const std::array<const char *, node_count> names = {"body",       "spine",    "neck",      "head", "eye_left",
                                                    "eye_right",  "lids",     "jaw",       "brow", "wing_left",
                                                    "wing_right", "arm_left", "arm_right", "legs"};

float deactivation_of(Node node)
{
    switch (node) {
        case Node::eye_left:
        case Node::eye_right:
        case Node::lids:
        case Node::jaw:
        case Node::brow:
            return face_deactivation_m;
        case Node::neck:
        case Node::head:
        case Node::arm_left:
        case Node::arm_right:
        case Node::legs:
            return limbs_deactivation_m;
        case Node::spine:
        case Node::wing_left:
        case Node::wing_right:
            return wings_deactivation_m;
        case Node::body:
            break;
    }
    return for_ever;
}

struct DofRange {
    const char *name;
    Node node;
    glm::vec3 axis;
    float first, last;  // radians; for the brow metres
    model::DofKind kind = model::DofKind::rotation;
};

// Yaw to the left, pitch up, roll towards the left shoulder. Lids and jaw from shut or open as their names say. Wings
// up behind the back, sweep towards the feet, arms forward and up, legs back.
const std::array<DofRange, 19> freedoms = {{{"spine_yaw", Node::spine, y, -0.40f, 0.40f},
                                            {"spine_pitch", Node::spine, -x, -0.30f, 0.30f},
                                            {"neck_yaw", Node::neck, y, -0.95f, 0.95f},
                                            {"neck_pitch", Node::neck, -x, -0.45f, 0.50f},
                                            {"head_roll", Node::head, -z, -0.40f, 0.40f},
                                            {"eye_left_yaw", Node::eye_left, y, -0.45f, 0.45f},
                                            {"eye_left_pitch", Node::eye_left, -x, -0.35f, 0.30f},
                                            {"eye_right_yaw", Node::eye_right, y, -0.45f, 0.45f},
                                            {"eye_right_pitch", Node::eye_right, -x, -0.35f, 0.30f},
                                            {"lids", Node::lids, x, 0, 1},
                                            {"jaw", Node::jaw, x, 0, 0.35f},
                                            {"brow", Node::brow, y, -0.006f, 0.012f, model::DofKind::translation},
                                            {"wing_left_flap", Node::wing_left, y, -0.90f, 1.00f},
                                            {"wing_left_sweep", Node::wing_left, -z, -0.35f, 0.60f},
                                            {"wing_right_flap", Node::wing_right, -y, -0.90f, 1.00f},
                                            {"wing_right_sweep", Node::wing_right, z, -0.35f, 0.60f},
                                            {"arm_left", Node::arm_left, -x, -0.35f, 0.70f},
                                            {"arm_right", Node::arm_right, -x, -0.45f, 0.70f},
                                            {"legs", Node::legs, x, -0.15f, 0.45f}}};

}  // namespace

void add_nodes(model::Rig &rig, const Joints &joints)
{
    for (size_t i = 0; i < joints.size(); ++i) {
        const bool root = static_cast<Node>(i) == Node::body;
        const size_t parent = static_cast<size_t>(joints[i].parent);
        rig.parents.push_back(root ? model::none : static_cast<uint32_t>(parent));
        math::Trs rest;
        rest.translation = root ? joints[i].at : joints[i].at - joints[parent].at;
        rig.rest.push_back(rest);
        rig.node_names.emplace_back(names[i]);
        rig.deactivation_m.push_back(deactivation_of(static_cast<Node>(i)));
        rig.palette.push_back({static_cast<uint32_t>(i), math::Affine()});
    }
    for (const DofRange &freedom : freedoms) {
        model::Dof dof;
        dof.node = static_cast<uint32_t>(freedom.node);
        dof.kind = freedom.kind;
        dof.axis = freedom.axis;
        dof.min = freedom.first, dof.max = freedom.last;
        rig.dofs.push_back(dof);
        rig.dof_names.emplace_back(freedom.name);
    }
}

}  // namespace claque::figures::flyer
