// Slender arms and hands made from the shared ones. Of the legs only the part below the hem exists.
#include <glm/geometric.hpp>

#include "lib/figures/patrician/patrician.h"
#include "lib/figures/skeleton.h"

namespace claque::figures::patrician
{

namespace
{

glm::vec3 slender(const Point &point)
{
    const glm::vec3 p = mirrored(point.position, point.side);
    if (point.region == Region::arm) {
        const glm::vec3 shoulder = skeleton().joint(Bone::upper_arm);
        const float along = glm::dot(p - shoulder, arm_direction());
        const glm::vec3 axis = shoulder + arm_direction() * along;
        return mirrored(axis + (p - axis) * 0.86f, point.side);
    }
    const glm::vec3 wrist = skeleton().joint(Bone::hand);
    return mirrored(wrist + (p - wrist) * hand_size, point.side);
}

void add_foot_alone(Mesh &mesh, Side side)
{
    const glm::vec3 ankle = skeleton().joint(Bone::foot);
    const size_t first = mesh.points.size();
    add_foot(mesh, side,
             add_ring(mesh, Region::leg, side, 8, {0.092f, 0.150f, -0.016f}, {1, 0, 0}, {0, 0, 1},
                      {0.036f, 0.038f, 0.034f, 0.034f}));
    for (size_t i = first; i < mesh.points.size(); ++i) {
        const glm::vec3 p = mirrored(mesh.points[i].position, side);
        const glm::vec3 small(ankle.x + (p.x - ankle.x) * foot_size, p.y, ankle.z + (p.z - ankle.z) * foot_size);
        mesh.points[i].position = mirrored(small, side);
    }
}

}  // namespace

void add_limbs(Mesh &mesh)
{
    for (const Side side : {Side::left, Side::right}) {
        const size_t first = mesh.points.size();
        add_arm(mesh, side);
        for (size_t i = first; i < mesh.points.size(); ++i) mesh.points[i].position = slender(mesh.points[i]);
        add_foot_alone(mesh, side);
    }
}

}  // namespace claque::figures::patrician
