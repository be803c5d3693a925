// Replaces a crowd's state by a restored one.
#include <algorithm>
#include <utility>

#include "lib/crowd/edits.h"

namespace claque::crowd
{

namespace
{

// Keeps the callbacks of actors with the same id in both states.
void keep_hooks(const Crowd &crowd, Tables &restored)
{
    const uint32_t rows = std::min(crowd.row_count(), restored.actors.all.size());
    for (uint32_t row = 0; row < rows; ++row) {
        const Extra *extra = crowd.extra_of(row);
        const bool same = crowd.alive(row) && restored.actors.all.slot(row).generation == crowd.actor(row).generation;
        if (!extra || !same || (!extra->hooks.before && !extra->hooks.after)) continue;
        make_extra(restored, row).hooks = extra->hooks;
    }
}

}  // namespace

void swap_state(Crowd &crowd, Crowd &restored)
{
    keep_hooks(crowd, restored.tables);

    // Commit: nothing below can fail.
    Tables &tables = restored.tables;
    for (uint32_t row = 0; row < restored.row_count(); ++row)
        if (restored.alive(row)) tables.actors.all[row].play_version = crowd.next_version++;
    for (uint32_t row = 0; row < restored.group_count(); ++row)
        if (tables.groups.all.in_use(row)) tables.groups.all[row].version = crowd.next_version++;
    ++crowd.structure;
    for (Changes *reader : crowd.readers) reader->everything = true;
    std::swap(crowd.tables, restored.tables);
}

}  // namespace claque::crowd
