// What a host's own arrays are made of: nodes and their degrees of freedom; parts with vertices, influences, morph targets.
#pragma once

#include <claque/template.h>

#include "lib/model/model.h"

namespace claque::api
{

void add_nodes(const clq_template_def &def, model::Model &model);
void add_joints(const clq_template_def &def, model::Model &model);
void add_dofs(const clq_template_def &def, model::Model &model);  // after parts, whose morph sets they may name

// After nodes and joints: rigid parts add palette entries, morphed ones morph sets. Throws base::Error (CLQ_ARGUMENT).
void add_parts(const clq_template_def &def, model::Model &model);

}  // namespace claque::api
