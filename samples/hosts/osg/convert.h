// Converts this host's scenery from the sample scenes' types to OpenSceneGraph's own.
#pragma once

#include <osg/Geometry>
#include <osg/Texture2D>

#include "samples/scenes/geometry.h"
#include "samples/scenes/texture.h"

namespace osg_host
{

// Indices [first, first + count) of a geometry, with arrays of its own.
osg::ref_ptr<osg::Geometry> geometry_of(const scenes::Geometry &from, size_t first, size_t count);
osg::ref_ptr<osg::Geometry> geometry_of(const scenes::Geometry &from);

osg::ref_ptr<osg::Texture2D> texture_of(const scenes::Image &image, bool repeats);

}  // namespace osg_host
