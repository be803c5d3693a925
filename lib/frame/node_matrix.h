// Where one node of one actor is, for hosts that hang something on it (S0 4.3).
#pragma once

#include "lib/frame/frame.h"

namespace claque::frame
{

// Column-major, in the world. time_s: a moment, or NaN: the tick that the last update showed, or its time for who was not
// seen. Evaluates the pose anew, of all nodes down to it, without the host's mechanisms. Throws std::bad_alloc.
void node_world_matrix(const crowd::Crowd &crowd, const Frame &frame, uint32_t row, uint32_t node, double time_s,
                       double out_matrix[16]);

}  // namespace claque::frame
