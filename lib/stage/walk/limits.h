// Numbers that a host gives, within their limits.
#pragma once

#include "lib/stage/api/boundary.h"

namespace claque::walk
{

using stage::boundary;
using stage::fail;
using stage::require;
using stage::require_size;

inline void require_range(const char *name, double value, double min, double max)
{
    if (!(value >= min && value <= max)) fail(CLQ_ARGUMENT, "%s is %g: %g to %g is wanted", name, value, min, max);
}

}  // namespace claque::walk
