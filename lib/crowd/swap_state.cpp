// A restored state in the place of the present one.
#include <utility>

#include "lib/crowd/crowd.h"

namespace claque::crowd
{

void Crowd::swap_state(Crowd &restored)
{
    for (uint32_t row = 0; row < row_count() && row < restored.row_count(); ++row) {
        const Extra *extra = extra_of(row);
        const bool same = alive(row) && actors_[row].generation == restored.actors_[row].generation;
        if (!extra || !same || (!extra->hooks.before && !extra->hooks.after)) continue;
        restored.extras_[restored.extra_slot(row)].hooks = extra->hooks;
    }

    // Committed from here on.
    const uint64_t structure = structure_version_ + 1;
    uint64_t version = next_version_;
    for (Actor &actor : restored.actors_)
        if (actor.generation & 1) actor.play_version = version++;
    for (Group &group : restored.groups_)
        if (group.generation & 1) group.version = version++;
    std::swap(seed_, restored.seed_);
    std::swap(alive_, restored.alive_);
    std::swap(first_free_, restored.first_free_);
    std::swap(first_free_group_, restored.first_free_group_);
    templates_.swap(restored.templates_);
    colours_.swap(restored.colours_);
    actors_.swap(restored.actors_);
    transforms_.swap(restored.transforms_);
    groups_of_.swap(restored.groups_of_);
    groups_.swap(restored.groups_);
    plays_.swap(restored.plays_);
    extents_.swap(restored.extents_);
    extras_of_.swap(restored.extras_of_);
    extras_.swap(restored.extras_);
    attached_.swap(restored.attached_);
    std::swap(first_free_extra_, restored.first_free_extra_);
    std::swap(first_free_attached_, restored.first_free_attached_);
    std::swap(behaviours_, restored.behaviours_);
    std::swap(layers_, restored.layers_);
    watched_.swap(restored.watched_);
    next_version_ = version;
    structure_version_ = structure;
}

}  // namespace claque::crowd
