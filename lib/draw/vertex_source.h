// The vertices of individuals that have none in the draw list, because GL's matrix stack places their parts.
#pragma once

#include "lib/draw/draw_list.h"

namespace claque::draw
{

class VertexSource
{
public:
    virtual ~VertexSource() = default;
    // None for lack of memory. Valid until the next call.
    virtual Vertices vertices_of(const Item &item) noexcept = 0;
};

}  // namespace claque::draw
