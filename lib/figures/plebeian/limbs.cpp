// Legs that are visible from above the knee: the shared ones with one more ring, so that the knee keeps its shape when
// it bends.
#include "lib/figures/plebeian/plebeian.h"

namespace claque::figures::plebeian
{

namespace
{

struct LegRow {
    glm::vec3 centre;
    Girth girth;  // front, back, outer, inner
};

const std::array<LegRow, 6> leg_rows = {{
    {{0.090f, 0.750f, 0.000f}, {0.074f, 0.064f, 0.068f, 0.062f}},   // thigh, inside the skirt
    {{0.091f, 0.560f, 0.003f}, {0.060f, 0.050f, 0.053f, 0.051f}},   // above the knee
    {{0.091f, 0.480f, 0.006f}, {0.055f, 0.046f, 0.050f, 0.049f}},   // knee
    {{0.093f, 0.365f, -0.008f}, {0.041f, 0.062f, 0.057f, 0.052f}},  // calf
    {{0.092f, 0.200f, -0.014f}, {0.033f, 0.041f, 0.036f, 0.035f}},
    {{0.092f, 0.100f, -0.018f}, {0.036f, 0.035f, 0.033f, 0.034f}},  // ankle
}};

}  // namespace

void add_bare_leg(Mesh &mesh, Side side)
{
    const Chart chart = on(side, Chart::leg);
    Chain above;
    std::vector<uint32_t> ring;
    for (const LegRow &row : leg_rows) {
        ring = add_ring(mesh, Region::leg, side, 8, row.centre, {1, 0, 0}, {0, 0, 1}, row.girth);
        const Chain next = ring_chain(ring, row.centre.y < 0.6f ? row.centre.y : 0.60f + 0.3f * (row.centre.y - 0.6f));
        if (!above.empty()) mesh.sew(chart, winding_of(side), next, above, Along::s);
        above = next;
    }
    add_foot(mesh, side, ring);
}

}  // namespace claque::figures::plebeian
