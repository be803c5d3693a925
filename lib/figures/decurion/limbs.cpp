// Stout arms and hands from the shared ones; of the legs only the shins, which show below the hem, and the feet.
#include <glm/geometric.hpp>

#include "lib/figures/decurion/decurion.h"
#include "lib/figures/skeleton.h"

namespace claque::figures::decurion
{

namespace
{

constexpr float stoutness = 1.10f;

// Of the arm, less and less towards the wrist; the hand is the shared one.
glm::vec3 stout(const Point &point)
{
    const glm::vec3 p = mirrored(point.position, point.side), shoulder = skeleton().joint(Bone::upper_arm);
    const float along = glm::dot(p - shoulder, arm_direction());
    const glm::vec3 axis = shoulder + arm_direction() * along;
    const float grow = along < 0.40f ? stoutness : 1 + (stoutness - 1) * (0.55f - along) / 0.15f;
    return mirrored(axis + (p - axis) * grow, point.side);
}

void add_shin(Mesh &mesh, Side side)
{
    const glm::vec3 ex(1, 0, 0), ez(0, 0, 1);
    const std::vector<uint32_t> top = add_ring(mesh, Region::leg, side, 8, {0.093f, 0.300f, -0.010f}, ex, ez,
                                               {0.042f, 0.058f, 0.052f, 0.050f}),
                                ankle = add_ring(mesh, Region::leg, side, 8, {0.092f, 0.105f, -0.018f}, ex, ez,
                                                 {0.039f, 0.039f, 0.037f, 0.038f});
    mesh.sew(on(side, Chart::leg), winding_of(side), ring_chain(ankle, 0.105f), ring_chain(top, 0.300f), Along::s);
    add_foot(mesh, side, ankle);
}

}  // namespace

void add_limbs(Mesh &mesh)
{
    for (const Side side : {Side::left, Side::right}) {
        const size_t first = mesh.points.size();
        add_arm(mesh, side);
        for (size_t i = first; i < mesh.points.size(); ++i)
            if (mesh.points[i].region == Region::arm) mesh.points[i].position = stout(mesh.points[i]);
        add_shin(mesh, side);
    }
}

}  // namespace claque::figures::decurion
