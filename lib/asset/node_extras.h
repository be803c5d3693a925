// Degrees of freedom for control mechanisms (S0 3) and distances of nodes and meshes (S0 5.1, 5.2), in `extras` of a
// glTF node. The format leaves the content of extras to applications.
//
//   "extras": {"claque": {
//       "deactivation_m": 40,           metres to the eye, more than 0: from there on the node and descendants are
//                                       not evaluated; default: never
//       "lod_m": [0, 40],               metres: the range of distances at which the node's mesh is drawn; without the
//                                       second number, [40], it has no end
//       "dofs": [
//           {"name": "gaze yaw",        unique; mechanisms find it by this name; default: no name
//            "kind": "rotation",        required: rotation, translation or morph
//            "axis": [0, 1, 0],         required for a rotation or translation: in the node's own frame
//            "min": -0.7,               required, with "max": the range in radians, model units or weight; min <= max
//            "max": 0.7,
//            "rest": 0,                 within the range; default: the value of the range nearest to 0
//            "morph_target": 2}         required for morph: the target of the node's mesh to whose weight it is added
//       ]
//   }}
//
// Unknown members are ignored.
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
    std::vector<model::Dof> dofs;  // their nodes are not set
    std::vector<std::string> dof_names;
    std::vector<std::string> dof_paths;  // their positions in the file, for messages
};

// Null if the extras have no claque member. Throws base::Error (CLQ_FORMAT) for a broken rule of the list above; names
// and morph targets are checked when the rig is built.
std::unique_ptr<NodeExtras> read_node_extras(const JsonView &extras, Budget &budget);

}  // namespace claque::asset
