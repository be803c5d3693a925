// The names of a template's clips, nodes, texture sets and degrees of freedom, for sentences about one that is absent,
// and a clip found by its name.
#pragma once

#include <string>
#include <vector>

#include "samples/scenes/check.h"

namespace scenes
{

std::vector<std::string> names_of_clips(const clq_template *tmpl);
std::vector<std::string> names_of_nodes(const clq_template *tmpl);
std::vector<std::string> names_of_texture_sets(const clq_template *tmpl);
std::vector<std::string> names_of_dofs(const clq_template *tmpl);
std::string lower_case(std::string name);
// "stand", else the first clip whose name holds "idle", else "stand", in any case of letters; CLQ_NONE: no clip.
uint32_t standing_clip(const clq_template *tmpl);

}  // namespace scenes
