// The body: overlapping plates of lacquer as on a procession's dragon, with a gold rim and a flame on each.
#include "samples/scenes/hundred/dragon_shape.h"

namespace scenes::hundred
{
namespace
{

struct Segment {
    uint32_t node, next;  // the joints that it spans
    double first, last;   // radius at each joint
};

constexpr Segment body[] = {
    {heart, chest, 0.60, 0.64},
    {chest, shoulder, 0.63, 0.58},
    {shoulder, neck1, 0.57, 0.46},
    {neck1, neck2, 0.45, 0.39},
    {neck2, neck3, 0.38, 0.34},
    {neck3, head, 0.33, 0.30},
    {loin, hip, 0.57, 0.52},
    {hip, tail1, 0.51, 0.45},
    {tail1, tail1 + 1, 0.44, 0.40},
    {tail1 + 1, tail1 + 2, 0.39, 0.35},
    {tail1 + 2, tail1 + 3, 0.345, 0.31},
    {tail1 + 3, tail1 + 4, 0.30, 0.27},
    {tail1 + 4, tail1 + 5, 0.26, 0.23},
    {tail1 + 5, tail1 + 6, 0.225, 0.195},
    {tail1 + 6, tail1 + 7, 0.19, 0.16},
    {tail1 + 7, tail1 + 8, 0.155, 0.125},
    {tail1 + 8, tail10, 0.12, 0.09},
    {tail10, fin, 0.085, 0.05},
};

void add_segment(PieceMesh &mesh, const Segment &s, Detail detail)
{
    constexpr int side_counts[] = {12, 8, 5};
    const int sides = side_counts[static_cast<int>(detail)];
    const int under = detail == Detail::fine ? 4 : detail == Detail::middle ? 2 : 1;
    const Point from = joint(s.node), way = joint(s.next) - from, along = unit(way);
    // The heart reaches back to the loin.
    const Point start = s.node == heart ? joint(loin) : from - along * (0.22 * s.first);
    const double first = s.node == heart ? 0.58 : 0.95 * s.first;
    const Point end = from + way;
    if (detail == Detail::coarse)
        mesh.loft({{start, first, first}, {end, s.last, s.last}}, sides, lacquer, belly, under);
    else {
        const double rim = 1.09 * s.last;
        mesh.loft({{start, first, first},
                   {from + way * 0.42, 0.5 * (s.first + s.last), 0.52 * (s.first + s.last)},
                   {end - along * 0.07, rim, rim}},
                  sides, lacquer, belly, under);
        mesh.loft({{end - along * 0.09, rim * 1.02, rim * 1.02}, {end, rim * 1.0, rim * 1.0}}, sides, gold, gold,
                  under);
    }
    // A flame on the back, leaning to the tail.
    const Point up = unit(cross(along, cross({0, 1, 0}, along)));
    const bool ahead = way.z > 0;
    const double top = 0.9 * 0.5 * (s.first + s.last), high = 0.16 + 0.42 * s.first;
    const Point fore = from + way * (ahead ? 0.80 : 0.12) + up * top,
                rear = from + way * (ahead ? 0.12 : 0.80) + up * top;
    const Point back = along * (ahead ? -1.0 : 1.0);
    mesh.blade(mane, fore, rear, rear + up * high + back * (0.4 * high), 0.05 + 0.08 * s.first);
}

void add_fin(PieceMesh &mesh, Detail detail)
{
    const Point root = joint(fin) + Point{0, 0, 0.12};
    const int rays = detail == Detail::fine ? 7 : detail == Detail::middle ? 5 : 3;
    for (int k = 0; k < rays; ++k) {
        const double turn = -0.9 + 1.8 * k / (rays - 1), reach = 1.05 - 0.35 * turn * turn + (k % 2 ? 0.12 : 0);
        const Point tip = root + Point{0, 0.15 + 0.85 * turn, -1 + 0.25 * turn * turn} * reach;
        const Point foot = Point{0, 0.20, -0.05 + 0.10 * turn};
        mesh.blade(mane, root - foot * 0.5, root + foot, tip, 0.06);
    }
}

}  // namespace

Point joint(uint32_t node)
{
    const Bone &bone = skeleton()[node];
    return {bone.x, bone.y, bone.z};
}

PieceMesh piece_of(uint32_t node, Detail detail)
{
    PieceMesh mesh;
    for (const Segment &segment : body)
        if (segment.node == node) add_segment(mesh, segment, detail);
    if (node == fin) add_fin(mesh, detail);
    if (node >= legs) add_leg_piece(mesh, node, detail);
    if (node >= head && node <= ear_r) add_head_piece(mesh, node, detail);
    return mesh;
}

}  // namespace scenes::hundred
