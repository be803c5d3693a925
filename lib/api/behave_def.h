// Checks descriptions of mechanisms and paths; throws base::Error naming the first broken rule.
#pragma once

#include <claque/behave.h>

#include "lib/crowd/mechanism.h"

namespace claque::api
{

// Appends every degree of freedom that it may write to `written`, once.
crowd::Mechanism mechanism_of(const clq_mechanism_def &def, const model::Template &tmpl,
                              std::pmr::memory_resource *memory, model::Array<uint32_t> &written);
crowd::RootPath path_of(const clq_root_path_def &def, std::pmr::memory_resource *memory);

}  // namespace claque::api
