// Layers: what one clip contributes to a pose. Layers apply in order: cross-fades replace, additive layers and inertial
// blends add (S2 3.3). A layer is a function of time and commands and keeps no state.
#pragma once

#include "lib/model/rig.h"

namespace claque::pose
{

enum class LayerKind : uint8_t {
    replace = 0,  // blends by `weight` from the pose below to this clip's pose
    add = 1       // adds `weight` of the difference from the reference pose to this clip's pose
};

struct Layer {
    uint32_t clip = model::none;  // none: the rest pose
    double time_s = 0;            // on the clip's own axis, like PoseJob::time_s
    float weight = 1;             // replace: [0, 1]; add: any finite
    LayerKind kind = LayerKind::replace;
    // For `add`: the reference pose; model::none: the rest pose.
    uint32_t reference_clip = model::none;
    double reference_time_s = 0;
    // [node_count], each in [0, 1], multiplied with the weight; null: 1 for all. Morph weights use the mask of their
    // node.
    const float *mask = nullptr;
};

// The maximum number of layers of one individual.
constexpr uint32_t max_layers = 8;

}  // namespace claque::pose
