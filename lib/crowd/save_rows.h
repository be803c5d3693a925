// How rows with ids are saved: every generation, followed by the row's contents if it is in use; then the free rows in
// the order in which they will be taken.
#pragma once

#include "lib/crowd/save.h"
#include "lib/crowd/save_fields.h"

namespace claque::crowd
{

template <class T, class Contents>
void write_rows(Writer &out, const base::SlotMap<T> &rows, const Contents &contents)
{
    out.count(rows.size());
    for (uint32_t row = 0; row < rows.size(); ++row) {
        out.value(rows.slot(row).generation);
        if (rows.in_use(row)) contents(row);
    }
    out.count(rows.free_count());
    rows.for_each_free([&](uint32_t row) { out.value(row); });
}

// `append` makes a row of a generation that may be invalid; `contents` reads a row in use. `what` names a row in error
// messages. Throws base::Error (CLQ_FORMAT).
template <class T, class Append, class Contents>
void read_rows(Reader &in, const char *what, base::SlotMap<T> &rows, const Append &append, const Contents &contents)
{
    const uint32_t count = in.count(4);
    uint32_t free = 0;
    for (uint32_t row = 0; row < count; ++row) {
        uint32_t generation = 0;
        in.value(generation);
        if (generation == base::SlotMap<T>::retired + 1)
            base::fail(CLQ_FORMAT, "a saved crowd's %s %u has a generation that none has", what, row);
        append(generation);
        if (rows.in_use(row)) contents(row);
        free += base::SlotMap<T>::can_be_free(generation);
    }
    const uint32_t listed = in.count(4);
    if (listed != free) base::fail(CLQ_FORMAT, "a saved crowd lists %u free %ss of %u", listed, what, free);
    Array<uint32_t> free_rows(listed, rows.memory());
    for (uint32_t &row : free_rows) in.value(row);
    for (uint32_t k = listed; k-- > 0;)
        if (free_rows[k] >= count || !rows.link_free(free_rows[k]))
            base::fail(CLQ_FORMAT, "a saved crowd lists %s %u as free, which is not, or twice", what, free_rows[k]);
}

void write_actor(Writer &out, const Crowd &crowd, uint32_t row);  // save_actors.cpp

}  // namespace claque::crowd
