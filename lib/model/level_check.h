// The rules of the levels in template.h; part of template_check.h.
#pragma once

#include <cmath>

#include "lib/base/error.h"
#include "lib/model/template.h"

namespace claque::model
{

template <class T>
void require_finite(const T *values, size_t count, const char *what)
{
    for (size_t i = 0; i < count; ++i)
        if (!std::isfinite(values[i])) base::fail(CLQ_ARGUMENT, "%s: number %zu is not finite", what, i);
}

inline void require_count(size_t have, size_t wanted, const char *what)
{
    if (have != wanted) base::fail(CLQ_ARGUMENT, "%s: %zu instead of %zu", what, have, wanted);
}

// These throw base::Error (CLQ_ARGUMENT) that names the first broken rule. The rig and the textures have been checked
// before.
void check_levels(const Template &tmpl);
// Checks the active nodes and entries; check_parts() comes first.
void check_skeleton(const Template &tmpl, size_t level);
// Checks parts and their spheres.
void check_parts(const Template &tmpl, const Level &level);
// Checks part_offsets of all surfaces.
void check_part_firsts(const Level &level);

}  // namespace claque::model
