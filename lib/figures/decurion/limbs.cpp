// Stout arms made from the shared ones, with the shared hands. Of the legs only the part below the hem exists.
#include <glm/geometric.hpp>

#include "lib/figures/decurion/decurion.h"
#include "lib/figures/skeleton.h"

namespace claque::figures::decurion
{

namespace
{

constexpr float stoutness = 1.10f;

// Thickens the arm, decreasing towards the wrist; the hand is the shared one.
glm::vec3 stout(const Point &point)
{
    const glm::vec3 p = mirrored(point.position, point.side), shoulder = skeleton().joint(Bone::upper_arm);
    const float along = glm::dot(p - shoulder, arm_direction());
    const glm::vec3 axis = shoulder + arm_direction() * along;
    const float grow = along < 0.40f ? stoutness : 1 + (stoutness - 1) * (0.55f - along) / 0.15f;
    return mirrored(axis + (p - axis) * grow, point.side);
}

void add_boot(Mesh &mesh, Side side)
{
    add_foot(mesh, side,
             add_ring(mesh, Region::leg, side, 8, {0.092f, 0.165f, -0.018f}, {1, 0, 0}, {0, 0, 1},
                      {0.038f, 0.042f, 0.038f, 0.038f}));
}

}  // namespace

void add_limbs(Mesh &mesh)
{
    for (const Side side : {Side::left, Side::right}) {
        const size_t first = mesh.points.size();
        add_arm(mesh, side);
        for (size_t i = first; i < mesh.points.size(); ++i)
            if (mesh.points[i].region == Region::arm) mesh.points[i].position = stout(mesh.points[i]);
        add_boot(mesh, side);
    }
}

}  // namespace claque::figures::decurion
