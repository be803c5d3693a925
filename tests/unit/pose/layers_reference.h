// Layers in double, on the second evaluation of clips: per axis, with quaternions as four numbers; shares no code with
// lib/pose.
#pragma once

#include "lib/pose/layer.h"
#include "reference.h"

namespace claque::reference
{

Pose evaluate(const model::Rig &rig, const std::vector<pose::Layer> &layers);

}  // namespace claque::reference
