// Growth of columns before a commit: memory is reserved first, so that the changes cannot fail.
#pragma once

#include <algorithm>
#include <cstddef>

namespace claque::base
{

// Makes room for `count` more elements; a column that grows does so by half at least. May throw std::bad_alloc. Changes
// capacity only.
template <class Column>
void reserve_more(Column &column, std::size_t count = 1)
{
    if (column.capacity() - column.size() >= count) return;
    column.reserve(column.size() + std::max(column.size() / 2 + 16, count));
}

}  // namespace claque::base
