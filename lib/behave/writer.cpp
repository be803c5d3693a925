#include "lib/behave/writer.h"

#include <cmath>

namespace claque::behave
{

bool is_active(const model::Rig &rig, const model::Level &level, uint32_t dof) noexcept
{
    if (level.active.empty()) return true;
    const model::Dof &d = rig.dofs[dof];
    return level.active[d.kind == model::DofKind::morph ? rig.morph_sets[d.node].node : d.node] != 0;
}

}  // namespace claque::behave

void clq_dof_writer::write(uint32_t dof, float value, float weight) noexcept
{
    using namespace claque;
    if (dof >= dofs.count || !std::isfinite(value) || !(weight > 0)) return;
    if (!behave::is_active(*rig, *level, dof)) return;
    const model::Dof &d = rig->dofs[dof];
    const float wanted = behave::clamped(d, value);
    float &there = dofs[dof];
    there = weight < 1 ? behave::clamped(d, there + (wanted - there) * weight) : wanted;
    ++counts->writes;
}
