// Checks the rules of template.h: a template that passes can be posed, skinned and drawn without a read out of range.
#pragma once

#include "lib/model/template.h"

namespace claque::model
{

// Throws base::Error (CLQ_ARGUMENT) that names the first broken rule.
void check(const Template &tmpl);

// The Sklsroot Bsphere and the reaches of nodes, of which check() is one part: a character whose poses grow without
// bound has none.
void check_spheres(const Template &tmpl);

}  // namespace claque::model
