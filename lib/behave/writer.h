// The one way into an actor's degrees of freedom.
#pragma once

#include "lib/behave/behave.h"

// What a host's mechanism is handed.
struct clq_dof_writer {
    const claque::model::Rig *rig = nullptr;
    const claque::model::Level *level = nullptr;
    claque::base::Span<float> dofs;
    claque::behave::Counts *counts = nullptr;

    // `weight` of the value, the rest of what is there; held to the range. Nothing of what is not finite, of no degree of
    // freedom, or of a node that is deactivated.
    void write(uint32_t dof, float value, float weight) noexcept;
};

namespace claque::behave
{

using Writer = ::clq_dof_writer;

// Whether what it moves is evaluated at this level.
bool is_active(const model::Rig &rig, const model::Level &level, uint32_t dof) noexcept;

inline float clamped(const model::Dof &dof, float value) noexcept
{
    return value < dof.min ? dof.min : value > dof.max ? dof.max : value;
}

}  // namespace claque::behave
