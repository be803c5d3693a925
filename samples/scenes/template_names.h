// What a template calls its clips and nodes, for sentences about names that it has not.
#pragma once

#include <string>
#include <vector>

#include "samples/scenes/check.h"

namespace scenes
{

std::vector<std::string> names_of_clips(const clq_template *tmpl);
std::vector<std::string> names_of_nodes(const clq_template *tmpl);

}  // namespace scenes
