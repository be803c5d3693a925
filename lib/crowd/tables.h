// The tables of a crowd: everything that a saved crowd holds, one table per subject. Each has one row per actor, with
// the same index in all of them; data of only some actors have rows of their own.
#pragma once

#include "lib/crowd/actors.h"
#include "lib/crowd/behaviours.h"
#include "lib/crowd/colours.h"
#include "lib/crowd/extras.h"
#include "lib/crowd/follows.h"
#include "lib/crowd/groups.h"
#include "lib/crowd/layers.h"

namespace claque::crowd
{

struct Tables {
    Tables(std::pmr::memory_resource *memory, uint64_t crowd_seed);

    uint64_t seed;
    Array<const model::Template *> templates;  // in the order of their first actors
    Array<ColourTable> colours;                // one per template
    Actors actors;
    Groups groups;
    Extras extras;
    Behaviours behaviours;
    Layers layers;
    Follows follows;
};

// A row in every table. Reserve first; then the other calls cannot fail.
void reserve_row(Tables &tables);
uint32_t take_row(Tables &tables) noexcept;
void free_row(Tables &tables, uint32_t row) noexcept;      // the actor must have left its group
uint32_t append_row(Tables &tables, uint32_t generation);  // of a saved crowd; may throw std::bad_alloc

// Whether events of the actor's clips are recorded. With `watched` false it cannot fail.
void set_watched(Actors &actors, uint32_t row, bool watched);

// The actor's extra data, created if it has none yet; may throw std::bad_alloc.
Extra &make_extra(Tables &tables, uint32_t row);
uint8_t *make_colours(Tables &tables, uint32_t row);  // returns its bytes

uint64_t bytes_of(const Tables &tables);  // held

}  // namespace claque::crowd
