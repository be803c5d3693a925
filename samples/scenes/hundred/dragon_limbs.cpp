// Legs with flames at their elbows, and feet with four claws, as dragons of rank have them.
#include "samples/scenes/hundred/dragon_shape.h"

namespace scenes::hundred
{
namespace
{

constexpr int side_counts[] = {8, 5, 3};

void add_foot(Clay &clay, Point at, Fineness fineness)
{
    clay.bead(belly, at + Point{0, -0.04, 0.06}, 0.13, 0.11, 0.20);
    if (fineness == Fineness::coarse) return;
    const int claws = fineness == Fineness::fine ? 4 : 2;
    for (int k = 0; k < claws; ++k) {
        const bool back = k == 3;
        const double aside = back ? 0 : claws == 2 ? 0.14 * (2 * k - 1) : 0.12 * (k - 1);
        const double ahead = back ? -1 : 1;
        const Point root = at + Point{aside * 0.6, -0.05, 0.14 * ahead};
        const Point bend = root + Point{aside * 0.9, 0.02, 0.17 * ahead};
        const Point tip = bend + Point{aside * 0.3, -0.15, 0.10 * ahead};
        clay.limb(horn, {root, bend, tip}, {0.055, 0.042, 0.006}, fineness == Fineness::fine ? 5 : 3);
    }
}

}  // namespace

void add_leg_piece(Clay &clay, uint32_t node, Fineness fineness)
{
    const uint32_t part = (node - legs) % 3;
    const int sides = side_counts[static_cast<int>(fineness)];
    const Point from = joint(node);
    if (part == 2) {
        add_foot(clay, from, fineness);
        return;
    }
    const Point to = joint(node + 1), way = to - from;
    const double outward = from.x > 0 ? 1 : -1;
    if (part == 0) {
        const Point inside = from - Point{0.22 * outward, -0.02, 0};
        clay.limb(lacquer, {inside, from + way * 0.35, to + way * 0.06}, {0.26, 0.25, 0.15}, sides);
        return;
    }
    clay.limb(lacquer, {from - way * 0.10, from + way * 0.25, from + way * 0.85}, {0.13, 0.165, 0.105}, sides);
    clay.limb(gold, {from + way * 0.80, to}, {0.125, 0.115}, sides);
    if (fineness == Fineness::coarse) return;
    const double behind = way.z > 0 ? -1 : 1;  // where the elbow points
    for (int k = 0; k < (fineness == Fineness::fine ? 3 : 1); ++k) {
        const Point root = from + way * (0.05 + 0.22 * k) + Point{0, 0, 0.10 * behind};
        clay.blade(mane, root, root + way * 0.26,
                   root + Point{0.12 * outward, 0.26 - 0.10 * k, (0.50 - 0.10 * k) * behind}, 0.07);
    }
}

}  // namespace scenes::hundred
