// What `inspect --nodes` adds: names that options, maps and scenarios want, and how a character could walk.
#pragma once

#include "samples/cli/characters.h"
#include "samples/cli/scene_arguments.h"

namespace cli
{

// Nodes with their parents, and materials.
void add_names(const clq_asset *asset, Json &report);
// The same of a prepared file, which has names of nodes alone.
void add_names(const clq_template *tmpl, Json &report);
// The legs and the pace that a walker of this class would have, or why it cannot walk.
void add_locomotion(scenes::Library &library, clq_template *tmpl, const scenes::SocialClass &described, Json &report);

// What these added.
void print_names(const Json &report);

}  // namespace cli
