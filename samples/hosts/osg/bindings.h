// What OSG leaves bound for its next drawable.
#pragma once

#include <osg/State>

namespace osg_host
{

// Unbinds buffers and arrays, with which claque refuses to draw, by osg::State's own means: it knows of it.
inline void clear_bindings(osg::State &state)
{
    state.disableAllVertexArrays();
    state.unbindVertexBufferObject();
    state.unbindElementBufferObject();
    state.setActiveTextureUnit(0);
    state.setClientActiveTextureUnit(0);
}

}  // namespace osg_host
