// A pose as the channels have it, to the key: the reference that resampled clips are measured against, and what is used
// where a template keeps none. Node by node, in local transforms.
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

// `active`: one a node, 0 where it stays at rest; null: all move. clip none: the rest pose.
void sample_exact(const model::Rig &rig, uint32_t clip, double time_s, const uint8_t *active, const LocalPose &out);

// All layers in order, on the rest pose. `spare` and `reference` are overwritten.
void sample_layers(const model::Rig &rig, base::Span<const Layer> layers, const uint8_t *active, const LocalPose &out,
                   const LocalPose &spare, const LocalPose &reference);

}  // namespace claque::pose
