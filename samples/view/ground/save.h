// The state of the testing ground as a scenario.
#pragma once

#include "samples/view/world.h"

namespace view
{

// The file of a character, or the name of a built-in one. Throws scenes::Failure if it has neither.
std::string character_of(const World &world, const clq_template *tmpl);

// The picked individual and all that have roles, as [[people]] of docs/scenarios.md, with the camera. Throws
// scenes::Failure if there is no individual to save, or a character has no file.
std::string scenario_text(const World &world, const Model &model);

}  // namespace view
