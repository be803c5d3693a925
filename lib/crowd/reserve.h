// Memory first, changes after: how a column grows ahead of a commit.
#pragma once

namespace claque::crowd
{

// Room for one more, grown by half: may throw, changes nothing that can be seen.
template <class Column>
void reserve_one(Column &column)
{
    if (column.size() == column.capacity()) column.reserve(column.size() + column.size() / 2 + 16);
}

}  // namespace claque::crowd
