// What a host commands one actor's mechanism: written down together with what that replaces, so that any moment shows
// what was true at it. Two orders are remembered. Calls throw base::Error and then change nothing.
#pragma once

#include "lib/crowd/crowd.h"

namespace claque::behave
{

// `point`: in the world, or in its group's space for a member; null: none.
void command_gaze(crowd::Crowd &crowd, crowd::Id id, uint32_t mechanism, const glm::dvec3 *point, double at_s);
void command_expression(crowd::Crowd &crowd, crowd::Id id, uint32_t mechanism, uint32_t pose, double at_s);
void command_phrase(crowd::Crowd &crowd, crowd::Id id, uint32_t mechanism, double at_s);

}  // namespace claque::behave
