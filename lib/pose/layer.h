// What one clip adds to a pose. A pose is made of layers in order: cross-fades replace, gestures and inertial blends add
// (S2 3.3). Everything about a layer is a function of time and commands; it keeps nothing.
#pragma once

#include "lib/model/rig.h"

namespace claque::pose
{

enum class LayerKind : uint8_t {
    replace = 0,  // goes `weight` of the way from what is below to this clip's pose
    add = 1       // adds `weight` of the difference from the reference pose to this clip's pose
};

struct Layer {
    uint32_t clip = model::none;  // none: the rest pose
    double time_s = 0;            // on the clip's own axis, like PoseJob::time_s
    float weight = 1;             // replace: [0, 1]; add: any finite
    LayerKind kind = LayerKind::replace;
    // add: the reference pose that differences are taken from; model::none: the rest pose
    uint32_t reference_clip = model::none;
    double reference_time_s = 0;
    // [node_count], each in [0, 1] and times the weight; null: 1 for all. Morph weights follow the mask of their node.
    const float *mask = nullptr;
};

// Most that one individual shows at once.
constexpr uint32_t max_layers = 8;

}  // namespace claque::pose
