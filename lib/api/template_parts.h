// The parts of a host's own arrays: vertices, influences, morph targets.
#pragma once

#include <claque/template.h>

#include "lib/model/model.h"

namespace claque::api
{

// After nodes and joints: rigid parts add palette entries, morphed ones morph sets. Throws base::Error (CLQ_ARGUMENT).
void add_parts(const clq_template_def &def, model::Model &model);

}  // namespace claque::api
