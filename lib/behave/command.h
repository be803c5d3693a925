// What a host commands one actor's mechanism: written down together with what that replaces, so that any moment shows
// what was true at it. Two orders are remembered. Calls throw base::Error and then change nothing.
#pragma once

#include "lib/crowd/crowd.h"

namespace claque::behave
{

// `point`: in the world, or in its group's space for a member; null: none.
void look(crowd::Crowd &crowd, crowd::Id id, uint32_t mechanism, const glm::dvec3 *point, double at_s);
void express(crowd::Crowd &crowd, crowd::Id id, uint32_t mechanism, uint32_t shape, double at_s);
void say(crowd::Crowd &crowd, crowd::Id id, uint32_t mechanism, double at_s);

}  // namespace claque::behave
