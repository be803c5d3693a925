// How large each person's silhouette would be if nothing else hid it.
#pragma once

#include <vector>

#include "samples/labels/sample.h"

namespace labels
{

// Groups whose boxes overlap nowhere, so that each group fits in one picture; by index of `boxes`. Boxes are rounded
// outwards to pixels; empty ones are in no group.
std::vector<std::vector<uint32_t>> groups_apart(const std::vector<Box> &boxes);

}  // namespace labels
