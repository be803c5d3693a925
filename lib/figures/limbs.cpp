// Arms and legs: rings round the bones with a girth of their own in four directions, so that calf, knee and forearm
// have their profiles.

#include "lib/figures/parts.h"
#include "lib/figures/skeleton.h"
#include "lib/math/trig.h"

namespace claque::figures
{

std::vector<uint32_t> add_ring(Mesh &mesh, Region region, Side side, int count, glm::vec3 centre, glm::vec3 ex,
                               glm::vec3 ez, Girth girth)
{
    std::vector<uint32_t> ring;
    for (int k = 0; k < count; ++k) {
        const float angle = 6.28318531f * static_cast<float>(k) / static_cast<float>(count);
        const float x = -math::sin(angle), z = -math::cos(angle);
        const glm::vec3 p = centre + ex * (x * (x > 0 ? girth.along_x : girth.against_x)) +
                            ez * (z * (z > 0 ? girth.front : girth.back));
        ring.push_back(mesh.add(mirrored(p, side), region, side));
    }
    return ring;
}

namespace
{

struct ArmRow {
    float along;  // from the shoulder
    float forward;
    Girth girth;  // front, back, palm side, back-of-hand side
};

const std::array<ArmRow, 4> arm_rows = {{
    {0.170f, 0.000f, {0.046f, 0.046f, 0.044f, 0.044f}},  // inside the sleeve
    {0.290f, 0.000f, {0.040f, 0.043f, 0.038f, 0.040f}},  // elbow
    {0.365f, 0.006f, {0.042f, 0.040f, 0.038f, 0.036f}},  // belly of the forearm
    {0.480f, 0.003f, {0.030f, 0.030f, 0.025f, 0.024f}},
}};

struct LegRow {
    glm::vec3 centre;
    Girth girth;  // front, back, outer, inner
};

const std::array<LegRow, 5> leg_rows = {{
    {{0.090f, 0.640f, 0.000f}, {0.070f, 0.070f, 0.066f, 0.062f}},   // thigh, inside the skirt
    {{0.091f, 0.490f, 0.006f}, {0.058f, 0.050f, 0.053f, 0.052f}},   // knee
    {{0.093f, 0.365f, -0.008f}, {0.044f, 0.066f, 0.061f, 0.056f}},  // calf
    {{0.092f, 0.200f, -0.014f}, {0.034f, 0.042f, 0.037f, 0.036f}},
    {{0.092f, 0.100f, -0.018f}, {0.036f, 0.035f, 0.033f, 0.034f}},  // ankle
}};

}  // namespace

void add_arm(Mesh &mesh, Side side)
{
    const glm::vec3 d = arm_direction(), ex = -arm_dorsal(), ez = arm_thumbward();
    const glm::vec3 shoulder = skeleton().joint(Bone::upper_arm);
    const Chart chart = on(side, Chart::arm);
    Chain before;
    for (const ArmRow &row : arm_rows) {
        const glm::vec3 centre = shoulder + d * row.along + ez * row.forward;
        const Chain next = ring_chain(add_ring(mesh, Region::arm, side, 6, centre, ex, ez, row.girth), -row.along);
        if (!before.empty()) mesh.sew(chart, winding_of(side), before, next, Along::s);
        before = next;
    }
    mesh.sew(chart, winding_of(side), before, ring_chain(add_hand(mesh, side), -0.545f), Along::s);
}

void add_leg(Mesh &mesh, Side side)
{
    const glm::vec3 ex(1, 0, 0), ez(0, 0, 1);
    const Chart chart = on(side, Chart::leg);
    Chain above;
    std::vector<uint32_t> ring;
    for (const LegRow &row : leg_rows) {
        ring = add_ring(mesh, Region::leg, side, 8, row.centre, ex, ez, row.girth);
        const Chain next = ring_chain(ring, row.centre.y);
        if (!above.empty()) mesh.sew(chart, winding_of(side), next, above, Along::s);
        above = next;
    }
    add_foot(mesh, side, ring);
}

}  // namespace claque::figures
