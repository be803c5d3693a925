// Checks and copies the host's descriptions of gaits, masks and layers.
#pragma once

#include <claque/play.h>

#include "lib/crowd/crowd.h"

namespace claque::api
{

// Each throws base::Error (CLQ_ARGUMENT) naming the first broken rule.
crowd::Gait gait_of(const clq_gait_def &def, const model::Template &tmpl, std::pmr::memory_resource *memory);
crowd::MaskOf mask_of(const clq_mask_def &def, const model::Template &tmpl, std::pmr::memory_resource *memory);
crowd::Layer layer_of(const clq_layer_def &def, const model::Template &tmpl);
crowd::Curve curve_of(const clq_curve &curve);

}  // namespace claque::api
