#include "samples/hosts/osg/plugin/up_axis.h"

namespace osg_plugin
{

clq_transform transform_of(const osg::Matrixd &to_world)
{
    clq_transform out = clq_transform_init();
    const osg::Vec3d at = to_claque(to_world.getTrans());
    osg::Matrixd turn;
    for (int row = 0; row < 3; ++row) {
        osg::Vec3d axis(to_world(row, 0), to_world(row, 1), to_world(row, 2));
        const double length = axis.normalize();
        if (row == 2) out.scale = static_cast<float>(length);
        for (int column = 0; column < 3; ++column) turn(row, column) = axis[column];
    }
    const osg::Quat q = turn.getRotate();
    const osg::Vec3d along = to_claque({q.x(), q.y(), q.z()});
    for (int k = 0; k < 3; ++k) out.position[k] = at[k], out.orientation_xyzw[k] = static_cast<float>(along[k]);
    out.orientation_xyzw[3] = static_cast<float>(q.w());
    return out;
}

clq_camera camera_of(const osg::Matrixd &world_to_eye, const osg::Matrixd &projection)
{
    const osg::Matrixd from_claque(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);
    clq_camera out = {};
    const osg::Vec3d eye = to_claque(osg::Matrixd::inverse(world_to_eye).getTrans());
    const osg::Quat turn = (from_claque * world_to_eye).getRotate();
    for (int k = 0; k < 3; ++k) out.eye[k] = eye[k];
    for (int k = 0; k < 4; ++k) out.rotation_xyzw[k] = static_cast<float>(turn[k]);
    for (int k = 0; k < 16; ++k) out.projection[k] = static_cast<float>(projection.ptr()[k]);
    return out;
}

}  // namespace osg_plugin
