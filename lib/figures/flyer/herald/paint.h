// The painters of the herald's charts.
#pragma once

#include "lib/figures/flyer/herald/herald.h"

namespace claque::figures::flyer::herald
{

Paint paint_whole_head(const Texel &t);
Paint paint_jaw(const Texel &t);
Paint paint_far_head(const Texel &t);
Paint paint_eye(const Texel &t);
Paint paint_lid(const Texel &t);

}  // namespace claque::figures::flyer::herald
