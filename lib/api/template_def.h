// Converts a host's own arrays to a Model. Lengths, NULLs and indices are checked here, values by model::check. Its
// counterpart for files is lib/asset.
#pragma once

#include <claque/template.h>

#include "lib/model/template.h"

namespace claque::api
{

// Throws base::Error (CLQ_ARGUMENT) naming the first broken rule.
model::Model model_of(const clq_template_def &def);

// Logs the facts of a split that its host should know, when the template is built and when it is read.
void log_report(clq_context *context, const model::Template &made);

model::HsbRange range_of(const clq_hsb_range &range);
clq_hsb_range range_of(const model::HsbRange &range);

}  // namespace claque::api
