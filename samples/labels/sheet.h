// All channels of a labelled picture side by side, to be looked at.
#pragma once

#include "samples/labels/sample.h"

namespace labels
{

// A PNG of four columns and two rows: colours, actors, zones, depth; normals, flow forward, visible shares, keypoints.
std::vector<unsigned char> sheet(const Sample &sample);

}  // namespace labels
