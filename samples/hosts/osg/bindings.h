// The buffers and arrays that OSG leaves bound for its next drawable.
#pragma once

#include <osg/State>

namespace osg_host
{

// Unbinds them, because claque refuses to draw while they are bound. osg::State does it, and so knows that they are not
// bound any more.
inline void clear_bindings(osg::State &state)
{
    state.disableAllVertexArrays();
    state.unbindVertexBufferObject();
    state.unbindElementBufferObject();
    state.setActiveTextureUnit(0);
    state.setClientActiveTextureUnit(0);
}

}  // namespace osg_host
