// Writes an actor's degrees of freedom; nothing else does.
#pragma once

#include "lib/behave/behave.h"

// The writer that a host's mechanism gets.
struct clq_dof_writer {
    const claque::model::Rig *rig = nullptr;
    const claque::model::Level *level = nullptr;
    claque::base::Span<float> dofs;
    claque::behave::Counts *counts = nullptr;

    // Blends a value in with `weight`, limited to its range. Ignores values that are not finite, unknown degrees of
    // freedom, and those of deactivated nodes.
    void write(uint32_t dof, float value, float weight) noexcept;
};

namespace claque::behave
{

using Writer = ::clq_dof_writer;

// True if the node that it moves is evaluated at this level.
bool is_active(const model::Rig &rig, const model::Level &level, uint32_t dof) noexcept;

inline float clamped(const model::Dof &dof, float value) noexcept
{
    return value < dof.min ? dof.min : value > dof.max ? dof.max : value;
}

}  // namespace claque::behave
