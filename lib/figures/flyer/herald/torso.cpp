// Neck, chest with its torque, the pleated skirt, and the wings. Each upper piece reaches into the lower one, so that
// no rotation opens a gap: the neck stands in the torque, the chest blouses over the belt.
#include "lib/figures/flyer/herald/herald.h"
#include "lib/figures/flyer/wing.h"

namespace claque::figures::flyer::herald
{

namespace
{

const std::vector<Ring> neck = {
    {{0, 0.415f, -0.020f}, 0.048f, 0.046f, 0.046f, 0.0f},
    {{0, 0.500f, -0.014f}, 0.042f, 0.042f, 0.044f, 0.6f},
    {{0, 0.580f, -0.006f}, 0.043f, 0.043f, 0.045f, 1.0f},
};

// From inside the blouse up to the throat.
const std::vector<Ring> chest = {
    {{0, 0.030f, 0.000f}, 0.098f, 0.080f, 0.080f, -0.04f}, {{0, 0.012f, 0.000f}, 0.136f, 0.112f, 0.108f, 0.00f},
    {{0, 0.060f, 0.000f}, 0.148f, 0.124f, 0.116f, 0.06f},  {{0, 0.130f, 0.000f}, 0.128f, 0.104f, 0.100f, 0.13f},
    {{0, 0.255f, -0.004f}, 0.150f, 0.116f, 0.106f, 0.26f}, {{0, 0.355f, -0.012f}, 0.172f, 0.104f, 0.106f, 0.36f},
    {{0, 0.420f, -0.020f}, 0.128f, 0.078f, 0.084f, 0.43f}, {{0, 0.452f, -0.022f}, 0.058f, 0.056f, 0.054f, 0.47f},
    {{0, 0.440f, -0.020f}, 0.030f, 0.030f, 0.030f, 0.48f},
};

const std::vector<Ring> torque = {
    {{0, 0.428f, -0.019f}, 0.100f, 0.082f, 0.080f, 0.0f},
    {{0, 0.446f, -0.016f}, 0.096f, 0.084f, 0.074f, 0.4f},
    {{0, 0.470f, -0.020f}, 0.062f, 0.058f, 0.054f, 0.8f},
    {{0, 0.462f, -0.020f}, 0.042f, 0.040f, 0.040f, 1.0f},
};

const std::vector<Ring> skirt = {
    {{0, -0.335f, -0.004f}, 0.212f, 0.190f, 0.186f, 0.0f}, {{0, -0.210f, 0.000f}, 0.186f, 0.162f, 0.160f, 0.4f},
    {{0, -0.080f, 0.000f}, 0.158f, 0.130f, 0.132f, 0.75f}, {{0, 0.000f, 0.000f}, 0.124f, 0.100f, 0.098f, 0.95f},
    {{0, 0.050f, 0.000f}, 0.094f, 0.076f, 0.076f, 1.0f},
};
const std::vector<Ring> lining = {
    {{0, -0.335f, -0.004f}, 0.212f, 0.190f, 0.186f, 0.0f, glm::vec3(-1, 0, 0)},
    {{0, -0.180f, 0.000f}, 0.000f, 0.000f, 0.000f, 1.0f, glm::vec3(-1, 0, 0)},
};

const Wing wing = {{0.050f, 0.365f, -0.098f}, {1, 1}, wing_back_chart, wing_front_chart};

}  // namespace

void add_wing_left(Mesh &mesh, int level) { add_wing(mesh, wing, Side::left, level); }
void add_wing_right(Mesh &mesh, int level) { add_wing(mesh, wing, Side::right, level); }

void add_neck(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    add_tube(to, {neck_chart, Side::left, level == 0 ? 7 : 4}, pick(neck, {0, 2}));
}

void add_chest(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    if (level == 0) {
        add_tube(to, {chest_chart, Side::left, 9}, pick(chest, {1, 2, 3, 4, 5, 6, 7}));
        add_tube(to, {collar_chart, Side::left, 8}, torque);
    } else if (level == 1) {
        add_tube(to, {chest_chart, Side::left, 8}, pick(chest, {1, 2, 3, 5, 6, 7}));
        add_tube(to, {collar_chart, Side::left, 6}, pick(torque, {0, 2, 3}));
    } else {
        const auto rings = level == 2 ? pick(chest, {1, 2, 5, 7}) : pick(chest, {1, 5, 7});
        add_tube(to, {chest_chart, Side::left, level == 2 ? 6 : 4}, rings);
    }
}

void add_skirt(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    const int around = level == 0 ? 12 : level == 1 ? 10 : level == 2 ? 6 : 5;
    const float pleat = level == 0 ? 0.055f : level == 1 ? 0.04f : 0;
    add_tube(to, {skirt_chart, Side::left, around, pleat},
             level == 0   ? skirt
             : level == 1 ? pick(skirt, {0, 2, 3, 4})
                          : pick(skirt, {0, 4}));
    // Seen from below: these rings run the other way round.
    add_tube(to, {lining_chart, Side::left, around, pleat}, lining);
}

}  // namespace claque::figures::flyer::herald
