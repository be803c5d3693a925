// The matrix of one node of one actor, for hosts that attach something to it (S0 4.3).
#pragma once

#include "lib/frame/frame.h"

namespace claque::frame
{

// Column-major, in the world. time_s: a time, or NaN: the tick that the last update showed, or the time of that update
// for an actor that it did not see. Evaluates the pose of all nodes from the root to this one, without the host's
// mechanisms. Throws std::bad_alloc.
void node_world_matrix(const crowd::Crowd &crowd, const Frame &frame, uint32_t row, uint32_t node, double time_s,
                       double out_matrix[16]);

}  // namespace claque::frame
