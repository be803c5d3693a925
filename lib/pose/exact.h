// Samples a pose directly from the channels, in local transforms, node by node. It is the reference for resampled
// clips, and is used if a template has none.
#pragma once

#include "lib/base/span.h"
#include "lib/pose/layer.h"

namespace claque::pose
{

// Local transforms [node_count] and morph weights [rig.rest_weights.size()] of one pose.
struct LocalPose {
    math::Trs *nodes = nullptr;
    float *weights = nullptr;
};

// `active`: [node_count], 0 for nodes that stay at rest; null: all may move. clip none: the rest pose.
void sample_exact(const model::Rig &rig, uint32_t clip, double time_s, const uint8_t *active, const LocalPose &out);

// Applies all layers in order to the rest pose. `spare` and `reference` are overwritten.
void sample_layers(const model::Rig &rig, base::Span<const Layer> layers, const uint8_t *active, const LocalPose &out,
                   const LocalPose &spare, const LocalPose &reference);

}  // namespace claque::pose
