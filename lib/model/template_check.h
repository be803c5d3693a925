// The rules of template.h as a test: what passes here can be posed, skinned and drawn without a read out of range.
#pragma once

#include "lib/model/template.h"

namespace claque::model
{

// Throws base::Error (CLQ_ARGUMENT) naming the first broken rule.
void check(const Template &tmpl);

}  // namespace claque::model
