// The parts of a conversion from a host's own arrays: nodes and degrees of freedom; parts with vertices, influences and
// morph targets.
#pragma once

#include <claque/template.h>

#include "lib/model/model.h"

namespace claque::api
{

void add_nodes(const clq_template_def &def, model::Model &model);
void add_joints(const clq_template_def &def, model::Model &model);
// after parts: a degree of freedom may name their morph sets
void add_dofs(const clq_template_def &def, model::Model &model);

// After nodes and joints: rigid parts add palette entries, morphed ones morph sets. Throws base::Error (CLQ_ARGUMENT).
void add_parts(const clq_template_def &def, model::Model &model);

}  // namespace claque::api
