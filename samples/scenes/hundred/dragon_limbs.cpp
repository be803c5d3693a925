// Legs with flames at their elbows, and feet with four claws, which mark a dragon of rank.
#include "samples/scenes/hundred/dragon_shape.h"

namespace scenes::hundred
{
namespace
{

constexpr int side_counts[] = {8, 5, 3};

void add_foot(PieceMesh &mesh, Point at, Detail detail)
{
    mesh.bead(belly, at + Point{0, -0.04, 0.06}, 0.13, 0.11, 0.20);
    if (detail == Detail::coarse) return;
    const int claws = detail == Detail::fine ? 4 : 2;
    for (int k = 0; k < claws; ++k) {
        const bool back = k == 3;
        const double aside = back ? 0 : claws == 2 ? 0.14 * (2 * k - 1) : 0.12 * (k - 1);
        const double ahead = back ? -1 : 1;
        const Point root = at + Point{aside * 0.6, -0.05, 0.14 * ahead};
        const Point bend = root + Point{aside * 0.9, 0.02, 0.17 * ahead};
        const Point tip = bend + Point{aside * 0.3, -0.15, 0.10 * ahead};
        mesh.limb(horn, {root, bend, tip}, {0.055, 0.042, 0.006}, detail == Detail::fine ? 5 : 3);
    }
}

}  // namespace

void add_leg_piece(PieceMesh &mesh, uint32_t node, Detail detail)
{
    const uint32_t part = (node - legs) % 3;
    const int sides = side_counts[static_cast<int>(detail)];
    const Point from = joint(node);
    if (part == 2) {
        add_foot(mesh, from, detail);
        return;
    }
    const Point to = joint(node + 1), way = to - from;
    const double outward = from.x > 0 ? 1 : -1;
    if (part == 0) {
        const Point inside = from - Point{0.22 * outward, -0.02, 0};
        mesh.limb(lacquer, {inside, from + way * 0.35, to + way * 0.06}, {0.26, 0.25, 0.15}, sides);
        return;
    }
    mesh.limb(lacquer, {from - way * 0.10, from + way * 0.25, from + way * 0.85}, {0.13, 0.165, 0.105}, sides);
    mesh.limb(gold, {from + way * 0.80, to}, {0.125, 0.115}, sides);
    if (detail == Detail::coarse) return;
    const double behind = way.z > 0 ? -1 : 1;  // direction of the elbow
    for (int k = 0; k < (detail == Detail::fine ? 3 : 1); ++k) {
        const Point root = from + way * (0.05 + 0.22 * k) + Point{0, 0, 0.10 * behind};
        mesh.blade(mane, root, root + way * 0.26,
                   root + Point{0.12 * outward, 0.26 - 0.10 * k, (0.50 - 0.10 * k) * behind}, 0.07);
    }
}

}  // namespace scenes::hundred
