// Growth of arrays whose needed size changes from update to update.
#pragma once

#include <cstddef>

namespace claque::base
{

// Makes room for `count` elements, and for a quarter more, so that slow growth does not move them in every update.
template <class Array>
void reserve_with_slack(Array &array, size_t count)
{
    if (array.capacity() < count) array.reserve(count + count / 4);
}

}  // namespace claque::base
