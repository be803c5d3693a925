// Arms, one with a trumpet and one with a scroll, and legs with winged sandals. Sleeves and skirt cover the joints.
#include <glm/geometric.hpp>

#include "lib/figures/flyer/herald/herald.h"

namespace claque::figures::flyer::herald
{

namespace
{

// Relative to the left shoulder; the right arm is mirrored.
struct ArmPose {
    glm::vec3 upper, fore;  // directions
    glm::vec3 thumb;        // direction of the thumb
};
const glm::vec3 shoulder(0.166f, 0.395f, -0.012f);

glm::vec3 unit(float x, float y, float z) { return glm::normalize(glm::vec3(x, y, z)); }

const ArmPose &pose_of(Side side)
{
    static const ArmPose left = {unit(0.42f, -0.86f, -0.30f), unit(0.22f, -0.88f, 0.42f), unit(-0.2f, 0.3f, 0.9f)};
    static const ArmPose right = {unit(0.50f, 0.42f, 0.76f), unit(-0.05f, 0.80f, 0.60f), unit(-0.6f, 0.4f, -0.6f)};
    return side == Side::left ? left : right;
}

glm::vec3 fist_of(Side side)
{
    const ArmPose &p = pose_of(side);
    return shoulder + p.upper * 0.235f + p.fore * 0.285f;
}

void add_arm(MeshBuilder &to, int level, Side side)
{
    const ArmPose &p = pose_of(side);
    const auto up = [&](float metres) { return shoulder + p.upper * metres; };
    const glm::vec3 elbow = up(0.235f);
    const auto down = [&](float metres) { return elbow + p.fore * metres; };
    const glm::vec3 ahead = side == Side::left ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, -0.2f);
    const std::vector<PathRing> sleeve = {{up(-0.068f), 0, 0, 0},
                                          {up(-0.045f), 0.055f, 0.055f, 0.055f},
                                          {up(0.010f), 0.076f, 0.074f, 0.076f},
                                          {up(0.140f), 0.082f, 0.080f, 0.082f},
                                          {up(0.110f), 0.030f, 0.030f, 0.030f}};
    const std::vector<PathRing> arm = {{up(0.080f), 0.040f, 0.042f, 0.042f},   {elbow, 0.037f, 0.037f, 0.038f},
                                       {down(0.070f), 0.038f, 0.040f, 0.036f}, {down(0.200f), 0.025f, 0.024f, 0.024f},
                                       {down(0.240f), 0.034f, 0.030f, 0.026f}, {down(0.290f), 0.036f, 0.034f, 0.030f},
                                       {down(0.325f), 0.022f, 0.024f, 0.022f}, {down(0.332f), 0, 0, 0}};
    const auto sleeve_rings = rings_along(sleeve, ahead), arm_rings = rings_along(arm, ahead);
    if (level == 0) {
        add_tube(to, {sleeve_chart, side, 7}, sleeve_rings);
        add_tube(to, {arm_chart, side, 5}, pick(arm_rings, {0, 1, 2, 3, 4, 6, 7}));
        const glm::vec3 root = down(0.235f) + p.thumb * 0.020f, tip = down(0.296f) + p.thumb * 0.044f;
        const glm::vec3 wide = glm::normalize(glm::cross(p.fore, p.thumb)) * 0.013f;
        const glm::vec3 c[4] = {mirrored(root + wide, side), mirrored(root - wide, side), mirrored(tip, side),
                                mirrored(down(0.285f) + p.thumb * 0.012f, side)};
        const Winding w = winding_of(side);
        const glm::vec2 at(0.5f, arm_rings[2].t);
        to.triangle(arm_chart, w, {c[0], at}, {c[2], at}, {c[1], at});
        to.triangle(arm_chart, w, {c[0], at}, {c[3], at}, {c[2], at});
        to.triangle(arm_chart, w, {c[1], at}, {c[2], at}, {c[3], at});
    } else if (level == 1) {
        add_tube(to, {sleeve_chart, side, 5}, pick(sleeve_rings, {0, 1, 2, 4}));
        add_tube(to, {arm_chart, side, 4}, pick(arm_rings, {0, 2, 4, 6, 7}));
    } else if (level == 2) {
        add_tube(to, {sleeve_chart, side, 4}, pick(sleeve_rings, {1, 2, 4}));
        add_tube(to, {arm_chart, side, 3}, pick(arm_rings, {0, 2, 6, 7}));
    } else {
        const std::vector<PathRing> whole = {{up(-0.030f), 0.058f, 0.058f, 0.058f},
                                             {elbow, 0.036f, 0.036f, 0.036f},
                                             {down(0.300f), 0.028f, 0.028f, 0.028f}};
        add_tube(to, {arm_chart, side, 3}, rings_along(whole, ahead));
    }
}

// A long straight trumpet, held at its centre of weight; mouthpiece behind the fist, bell ahead.
void add_trumpet(MeshBuilder &to, int level)
{
    const glm::vec3 fist = mirrored(fist_of(Side::right), Side::right);
    const glm::vec3 d = unit(-0.12f, 0.50f, 0.86f);
    const auto at = [&](float metres) { return fist + d * metres; };
    const std::vector<PathRing> beads = {
        {at(0.660f), 0, 0, 0},
        {at(0.700f), 0.082f, 0.082f, 0.082f},
        {at(0.630f), 0.040f, 0.040f, 0.040f},
        {at(0.480f), 0.019f, 0.019f, 0.019f},
        {at(-0.280f), 0.010f, 0.010f, 0.010f},
        {at(-0.300f), 0.018f, 0.018f, 0.018f},
        {at(-0.305f), 0, 0, 0},
    };
    std::vector<Ring> rings = rings_along(beads, glm::vec3(0, 1, 0));
    // The bell opens against the direction of the path, so its frame comes from the tube's own direction.
    for (Ring &ring : rings) {
        ring.ez = glm::normalize(glm::vec3(0, 1, 0) - d * d.y);
        ring.ex = glm::cross(d, ring.ez);
    }
    if (level == 0) add_tube(to, {trumpet_chart, Side::left, 6}, pick(rings, {0, 2, 3, 4, 5, 6}));
    else if (level == 1) add_tube(to, {trumpet_chart, Side::left, 4}, pick(rings, {2, 3, 5, 6}));
    else if (level == 2) add_tube(to, {trumpet_chart, Side::left, 3}, pick(rings, {2, 3, 5}));
    else add_tube(to, {trumpet_chart, Side::left, 3}, pick(rings, {2, 4}));
}

void add_scroll(MeshBuilder &to, int level)
{
    if (level > 1) return;
    const glm::vec3 d = unit(-0.55f, 0.10f, 0.83f), fist = fist_of(Side::left);
    const auto at = [&](float metres) { return fist + d * metres; };
    const std::vector<Ring> rings = rings_along({{at(0.1520f), 0, 0, 0},
                                                 {at(0.1500f), 0.026f, 0.026f, 0.026f},
                                                 {at(-0.1400f), 0.026f, 0.026f, 0.026f},
                                                 {at(-0.1420f), 0, 0, 0}},
                                                glm::vec3(0, 1, 0));
    add_tube(to, {scroll_chart, Side::left, level == 0 ? 5 : 3}, level == 0 ? rings : pick(rings, {1, 2}));
}

// Straight on the left, bent back at the knee on the right, toes pointed.
void add_leg(MeshBuilder &to, int level, Side side)
{
    const bool bent = side == Side::right;
    const glm::vec3 hip(0.078f, -0.100f, 0), knee(0.086f, -0.435f, bent ? 0.070f : 0.010f);
    const glm::vec3 shin = bent ? unit(0.02f, -0.90f, -0.44f) : unit(0, -0.99f, -0.06f);
    const glm::vec3 sole = bent ? unit(0.02f, -0.93f, -0.22f) : unit(0.05f, -0.90f, 0.36f);
    const auto thigh = [&](float share) { return hip + (knee - hip) * share; };
    const auto calf = [&](float metres) { return knee + shin * metres; };
    const glm::vec3 heel = calf(0.285f);
    const auto foot = [&](float metres) { return heel + sole * metres; };
    const std::vector<PathRing> beads = {
        {thigh(0), 0.074f, 0.072f, 0.074f},
        {thigh(0.6f), 0.068f, 0.066f, 0.068f},
        {thigh(0.97f), 0.049f, 0.052f, 0.047f},
        {calf(0.090f), 0.052f, 0.046f, 0.060f},
        {calf(0.235f), 0.031f, 0.032f, 0.034f},
        {heel, 0.034f, 0.036f, 0.044f},
        {foot(0.075f), 0.040f, 0.034f, 0.022f},
        {foot(0.135f), 0.036f, 0.020f, 0.018f},
        {foot(0.152f), 0, 0, 0},
    };
    const auto rings = rings_along(beads, glm::vec3(0, 0, 1));  // from the toes up
    if (level == 0) add_tube(to, {leg_chart, side, 6}, pick(rings, {0, 1, 2, 3, 4, 5, 6, 8}));
    else if (level == 1) add_tube(to, {leg_chart, side, 5}, pick(rings, {0, 1, 3, 5, 6, 8}));
    else if (level == 2) add_tube(to, {leg_chart, side, 3}, pick(rings, {0, 3, 6, 7}));
    else add_tube(to, {leg_chart, side, 3}, pick(rings, {0, 3, 7}));
    if (level > 0) return;
    // The small wing of the sandal, outside and behind the ankle: a thin wedge, visible from both sides.
    const glm::vec3 root = calf(0.245f) + glm::vec3(0.031f, 0, -0.012f), out(0.040f, 0.030f, -0.055f);
    const glm::vec3 tip = root + out * 2.0f, top = root + glm::vec3(0.006f, 0.052f, -0.004f);
    const glm::vec3 low = root + out * 0.9f + glm::vec3(0, -0.030f, -0.012f);
    const Winding w = winding_of(side), back = winding_of(side == Side::left ? Side::right : Side::left);
    const MeshBuilder::SheetVertex a = {mirrored(root, side), {0, 0.4f}}, b = {mirrored(top, side), {0.2f, 1}},
                                   c = {mirrored(tip, side), {1, 0.8f}}, e = {mirrored(low, side), {0.5f, 0}};
    const auto behind = [&](MeshBuilder::SheetVertex stop) {
        stop.first += mirrored(glm::vec3(-0.004f, 0, -0.002f), side);
        return stop;
    };
    to.triangle(talaria_chart, w, a, c, b);
    to.triangle(talaria_chart, w, a, e, c);
    to.triangle(talaria_chart, back, behind(a), behind(c), behind(b));
    to.triangle(talaria_chart, back, behind(a), behind(e), behind(c));
}

}  // namespace

void add_arm_left(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    add_arm(to, level, Side::left);
    add_scroll(to, level);
}

void add_arm_right(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    add_arm(to, level, Side::right);
    add_trumpet(to, level);
}

void add_far_trumpet(Mesh &mesh)
{
    MeshBuilder to(mesh);
    add_trumpet(to, 3);
}

void add_legs(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    for (const Side side : {Side::left, Side::right}) add_leg(to, level, side);
}

}  // namespace claque::figures::flyer::herald
