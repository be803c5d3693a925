// Commands of the host to one actor's mechanism. Each is stored together with the one that it replaces, so that any
// time shows what held then; two commands are kept. Functions throw base::Error and then change nothing.
#pragma once

#include "lib/crowd/crowd.h"

namespace claque::behave
{

// `point`: in the world, or for a member in its group's space; null: no target.
void command_gaze(crowd::Crowd &crowd, crowd::Id id, uint32_t mechanism, const glm::dvec3 *point, double at_s);
void command_expression(crowd::Crowd &crowd, crowd::Id id, uint32_t mechanism, uint32_t pose, double at_s);
void command_phrase(crowd::Crowd &crowd, crowd::Id id, uint32_t mechanism, double at_s);

}  // namespace claque::behave
