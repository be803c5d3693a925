// How a glTF file says what a node tree can do beside what its clips show: degrees of freedom for control mechanisms (S0
// 3), and which nodes and meshes go on to which distance (S0 5.1, 5.2). In `extras` of a node, which the format leaves to
// us.
//
//   "extras": {"claque": {
//       "deactivation_m": 40,           metres from the eye, more than 0: from there on the node and all below it are
//                                       not evaluated; for ever
//       "lod_m": [0, 40],               metres: the node's mesh is drawn from the first on, up to the last; with the
//                                       last left out, [40], for ever
//       "dofs": [
//           {"name": "gaze yaw",        how mechanisms find it, no other may have it; none
//            "kind": "rotation",        required: rotation, translation or morph
//            "axis": [0, 1, 0],         of a rotation or translation, required: in the node's own frame
//            "min": -0.7,             required, the range: radians, model units or weight; first <= last
//            "max": 0.7,
//            "rest": 0,                 within the range; 0, or the end of the range that is nearest to it
//            "morph_target": 2}         of a morph one, required: which target of the node's mesh its number is added to
//       ]
//   }}
//
// Unknown members are passed over.
#pragma once

#include <limits>
#include <memory>

#include "lib/asset/budget.h"
#include "lib/asset/json_view.h"
#include "lib/model/model.h"

namespace claque::asset
{

struct NodeExtras {
    float deactivation_m = std::numeric_limits<float>::infinity();
    float lod_min_m = 0, lod_max_m = std::numeric_limits<float>::infinity();
    bool has_lod = false;
    std::vector<model::Dof> dofs;  // without node
    std::vector<std::string> dof_names;
    std::vector<std::string> dof_paths;  // where in the file they stand
};

// Null where they say nothing in our name. Throws base::Error (CLQ_FORMAT) where something breaks the rules above; names
// and morph targets are looked at when the rig is put together.
std::unique_ptr<NodeExtras> read_node_extras(const JsonView &extras, Budget &budget);

}  // namespace claque::asset
