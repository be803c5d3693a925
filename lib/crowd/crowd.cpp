#include "lib/crowd/crowd.h"

#include <algorithm>

#include "lib/base/error.h"

namespace claque::crowd
{

uint32_t Crowd::row_of(Id id) const
{
    const uint32_t row = tables.actors.all.find(id);
    if (row == base::no_slot)
        base::fail(CLQ_STALE_ID, "no actor has index %u and generation %u", id.index1, id.generation);
    return row;
}

uint32_t Crowd::group_row_of(Id id) const
{
    const uint32_t row = tables.groups.all.find(id);
    if (row == base::no_slot)
        base::fail(CLQ_STALE_ID, "no group has index %u and generation %u", id.index1, id.generation);
    return row;
}

bool Crowd::has_template(const model::Template &tmpl) const
{
    return std::find(tables.templates.begin(), tables.templates.end(), &tmpl) != tables.templates.end();
}

size_t Crowd::colour_bytes() const
{
    size_t bytes = 0;
    for (const ColourTable &table : tables.colours) bytes += table.colour_bytes();
    return bytes;
}

}  // namespace claque::crowd
