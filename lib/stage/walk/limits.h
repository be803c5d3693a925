// Numbers that a host gives, within their limits.
#pragma once

#include <claque/navigation.h>

#include <cstddef>

#include "lib/stage/api/boundary.h"

namespace claque::walk
{

using stage::boundary;
using stage::fail;
using stage::require;
using stage::require_size;

}  // namespace claque::walk

namespace claque::stage
{

// In the first release it had no ground.
template <>
struct EarlierSizes<clq_walkers_def> {
    static constexpr uint32_t sizes[] = {offsetof(clq_walkers_def, ground)};
};

}  // namespace claque::stage

namespace claque::walk
{

inline void require_range(const char *name, double value, double min, double max)
{
    if (!(value >= min && value <= max)) fail(CLQ_ARGUMENT, "%s is %g: %g to %g is wanted", name, value, min, max);
}

}  // namespace claque::walk
