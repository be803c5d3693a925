// The coarse levels of the herald in the rest pose: what remains after limbs are deactivated, and finally one body with
// wings.
#include "lib/figures/flyer/herald/herald.h"

namespace claque::figures::flyer::herald
{

void add_bust(Mesh &mesh, int)
{
    add_far_head(mesh, 1);
    add_chest(mesh, 3);
    add_arm_left(mesh, 3);
    add_arm_right(mesh, 3);
}

void add_lower_half(Mesh &mesh, int)
{
    add_skirt(mesh, 3);
    add_legs(mesh, 3);
}

void add_whole(Mesh &mesh, int)
{
    MeshBuilder to(mesh);
    const std::vector<Ring> body = {{{0, -0.80f, -0.04f}, 0, 0, 0, 0},
                                    {{0, -0.28f, 0}, 0.190f, 0.170f, 0.170f, 0.3f},
                                    {{0, 0.40f, 0}, 0.150f, 0.120f, 0.120f, 0.7f},
                                    {{0, 0.81f, 0}, 0, 0, 0, 1}};
    add_tube(to, {far_limb_chart, Side::left, 3}, body);
    add_wing_left(mesh, 3);
    add_wing_right(mesh, 3);
    add_far_trumpet(mesh);
}

}  // namespace claque::figures::flyer::herald
