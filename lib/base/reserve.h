// Growth of columns before a commit: memory is reserved first, so that the changes cannot fail.
#pragma once

#include <algorithm>
#include <cstddef>

namespace claque::base
{

// From here on columns grow by less: room that is not used yet would be most of what a large crowd wastes.
constexpr std::size_t large_column = 4096;

// Makes room for `count` more elements; a column that grows does so by half at least, a large one by a quarter. May
// throw std::bad_alloc. Changes capacity only.
template <class Column>
void reserve_more(Column &column, std::size_t count = 1)
{
    const std::size_t size = column.size();
    if (column.capacity() - size >= count) return;
    column.reserve(size + std::max(size < large_column ? size / 2 + 16 : size / 4, count));
}

}  // namespace claque::base
