// OpenSceneGraph's viewers and SUMO have z up and look at a person's face from -y; claque has y up, and its characters
// face +z. One rotation leads from claque's world to OSG's: (x, y, z) becomes (x, -z, y).
#pragma once

#include <claque/view.h>

#include <osg/Matrixd>

namespace osg_plugin
{

inline osg::Vec3d to_claque(const osg::Vec3d &v) { return {v.x(), v.z(), -v.y()}; }

// Where a matrix of OSG's world puts the origin, how it turns it, and the length of what was one metre up.
clq_transform transform_of(const osg::Matrixd &to_world);

// The camera of GL's matrices for OSG's world.
clq_camera camera_of(const osg::Matrixd &world_to_eye, const osg::Matrixd &projection);

}  // namespace osg_plugin
