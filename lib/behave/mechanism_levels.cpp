// Behavioural level of detail (S0 5.3).
#include "lib/behave/writer.h"

namespace claque::behave
{

namespace
{

using crowd::HostMechanism;
using crowd::Mechanism;

bool keeps_memory(const Mechanism &mechanism)
{
    const HostMechanism *host = std::get_if<HostMechanism>(&mechanism.kind);
    return host && host->memory;
}

// True if the skeleton has lost every node that the mechanism writes. A host's mechanism may write all nodes; clips
// need none.
bool is_lost(const crowd::Behaviours &behaviours, const Mechanism &mechanism, const model::Level &level)
{
    if (level.active.empty() || std::holds_alternative<crowd::Idle>(mechanism.kind)) return false;
    const model::Rig &rig = mechanism.tmpl->rig;
    const base::Span<const uint32_t> written = behaviours.written(mechanism);
    const uint32_t count = written.count ? written.count : static_cast<uint32_t>(rig.dofs.size());
    for (uint32_t i = 0; i < count; ++i)
        if (is_active(rig, level, written.count ? written[i] : i)) return false;
    return count > 0;
}

uint32_t level_of(const crowd::Behaviours &behaviours, const Mechanism &mechanism, float distance_m,
                  const model::Level &level)
{
    uint32_t k = 0;
    while (k < crowd::max_behaviour_levels - 1 && distance_m >= mechanism.level_m[k]) ++k;
    if (keeps_memory(mechanism)) return k;
    return distance_m >= mechanism.off_m || is_lost(behaviours, mechanism, level) ? off : k;
}

}  // namespace

MechanismLevels mechanism_levels(const crowd::Crowd &crowd, uint32_t row, float distance_m,
                                 const model::Level &level) noexcept
{
    static_assert(4 * crowd::max_mechanisms <= 8 * sizeof(MechanismLevels), "four bits per attachment");
    const crowd::Behaviours &behaviours = crowd.behaviours();
    MechanismLevels levels = 0;
    uint32_t slot = 0;
    for (uint32_t i = behaviours.first_attachment(row); i != model::none;
         i = behaviours.attachment_at(i).next, ++slot) {
        const Mechanism &mechanism = behaviours.mechanism(behaviours.attachment_at(i).mechanism);
        levels |= static_cast<MechanismLevels>(level_of(behaviours, mechanism, distance_m, level)) << (4 * slot);
    }
    return levels;
}

bool has_memory(const crowd::Crowd &crowd, uint32_t row) noexcept
{
    const crowd::Behaviours &behaviours = crowd.behaviours();
    for (uint32_t i = behaviours.first_attachment(row); i != model::none; i = behaviours.attachment_at(i).next)
        if (keeps_memory(behaviours.mechanism(behaviours.attachment_at(i).mechanism))) return true;
    return false;
}

}  // namespace claque::behave
