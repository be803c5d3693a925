// Characters by the library's own path: models split by meshsplit, posed and skinned.
#pragma once

#include "tests/gl/support/posed_model.h"

namespace gltest
{

// A model of one rigid part whose image holds `map` as the given keys, one per zone.
model::Model model_of(const Mesh &mesh, const ZoneMap &map, const std::vector<uint8_t> &keys, model::Wrap wrap);

// Splits it; white, so that the picture shows pure zone colours. In the pose of `clip` (model::none: at rest) at
// `time_s`.
PosedModel split_posed(const model::Model &model, uint32_t clip = model::none, double time_s = 0);

// The same with its own textures.
PosedModel split_unwhitened(const model::Model &model, uint32_t clip = model::none, double time_s = 0);

// Positions and normals of level 0 in a pose, copies included.
void skin(const model::Template &tmpl, uint32_t clip, double time_s, std::vector<float> &positions,
          std::vector<float> &normals);

}  // namespace gltest
