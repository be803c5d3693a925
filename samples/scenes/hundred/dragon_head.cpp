// The head: a long skull with horns, brows and fangs, a jaw with a beard, whiskers, and flames round the neck.
#include <cmath>

#include "samples/scenes/hundred/dragon_shape.h"

namespace scenes::hundred
{
namespace
{

constexpr double sides_of_face[] = {1, -1};

void add_skull(PieceMesh &mesh, Detail detail)
{
    const int sides = detail == Detail::fine ? 10 : detail == Detail::middle ? 6 : 4;
    mesh.loft({{{0, 2.00, 5.42}, 0.30, 0.30},
               {{0, 2.10, 5.75}, 0.37, 0.30},
               {{0, 2.12, 6.05}, 0.33, 0.24},
               {{0, 2.06, 6.38}, 0.22, 0.16},
               {{0, 2.05, 6.72}, 0.22, 0.15},
               {{0, 2.02, 6.95}, 0.14, 0.09}},
              sides, lacquer, mouth, detail == Detail::fine ? 2 : 1);
    for (const double s : sides_of_face) {
        const std::vector<Point> sweep = {
            {0.17 * s, 2.28, 5.80}, {0.28 * s, 2.60, 5.48}, {0.38 * s, 2.76, 5.05}, {0.34 * s, 3.06, 4.62}};
        mesh.limb(horn, sweep, {0.09, 0.075, 0.055, 0.008}, detail == Detail::fine ? 6 : 3);
        if (detail == Detail::coarse) continue;
        mesh.limb(horn, {{0.30 * s, 2.64, 5.42}, {0.50 * s, 3.02, 5.34}}, {0.055, 0.008}, 4);
        mesh.blade(gold, {0.10 * s, 2.30, 6.28}, {0.36 * s, 2.28, 5.78}, {0.44 * s, 2.56, 5.72}, 0.09);
        mesh.bead(gold, {0.11 * s, 2.16, 6.84}, 0.075, 0.07, 0.10);
        if (detail != Detail::fine) continue;
        for (int k = 0; k < 4; ++k) {
            const double z = 6.84 - 0.17 * k, x = 0.19 - 0.012 * (k == 0);
            mesh.blade(horn, {x * s, 1.96, z}, {x * s, 1.96, z - 0.09}, {x * s, k == 0 ? 1.76 : 1.85, z - 0.05}, 0.05);
        }
    }
}

void add_jaw(PieceMesh &mesh, Detail detail)
{
    const int sides = detail == Detail::fine ? 8 : 4;
    mesh.loft({{{0, 1.86, 5.60}, 0.27, 0.12},
               {{0, 1.80, 5.98}, 0.24, 0.11},
               {{0, 1.80, 6.40}, 0.17, 0.08},
               {{0, 1.82, 6.76}, 0.11, 0.05}},
              sides, lacquer, belly, sides / 2);
    if (detail != Detail::fine) return;
    mesh.loft({{{0, 1.90, 5.80}, 0.12, 0.04}, {{0, 1.90, 6.35}, 0.10, 0.03}, {{0, 1.92, 6.68}, 0.04, 0.015}}, 6, mouth,
              mouth, 1);
    for (const double s : sides_of_face)
        mesh.blade(horn, {0.10 * s, 1.84, 6.70}, {0.11 * s, 1.84, 6.60}, {0.12 * s, 2.02, 6.68}, 0.05);
    for (int k = -2; k <= 2; ++k) {
        const double x = 0.06 * k;
        mesh.blade(mane, {x, 1.75, 6.58 - 0.02 * k * k}, {x, 1.72, 6.32 - 0.02 * k * k},
                   {x * 1.8, 1.36 + 0.05 * std::abs(k), 6.22}, 0.06);
    }
}

void add_crest(PieceMesh &mesh, Detail detail)
{
    const int flames = detail == Detail::fine ? 9 : detail == Detail::middle ? 5 : 3;
    for (int k = 0; k < flames; ++k) {
        const double turn = -2.1 + 4.2 * k / (flames - 1), long_m = 0.78 + (k % 2 ? 0.22 : 0.0);
        const Point out = {std::sin(turn), std::cos(turn), 0}, aside = {std::cos(turn), -std::sin(turn), 0};
        const Point root = Point{0, 2.03, 5.52} + out * 0.26;
        const double half = detail == Detail::fine ? 0.13 : 0.2;
        mesh.blade(mane, root - aside * half, root + aside * half,
                   root + out * (0.42 * long_m) + Point{0, 0.05, -long_m}, 0.10);
    }
}

void add_whisker(PieceMesh &mesh, double s, Detail detail)
{
    if (detail == Detail::coarse) return;
    mesh.limb(gold,
              {{0.18 * s, 1.98, 6.74},
               {0.48 * s, 1.86, 6.92},
               {0.80 * s, 2.02, 6.72},
               {0.98 * s, 2.42, 6.36},
               {1.22 * s, 2.62, 5.98}},
              {0.04, 0.036, 0.030, 0.022, 0.005}, detail == Detail::fine ? 4 : 3);
}

}  // namespace

void add_head_piece(PieceMesh &mesh, uint32_t node, Detail detail)
{
    const double s = joint(node).x > 0 ? 1 : -1;
    switch (node) {
        case head:
            add_skull(mesh, detail);
            break;
        case jaw:
            add_jaw(mesh, detail);
            break;
        case crest:
            add_crest(mesh, detail);
            break;
        case eye_l:
        case eye_r:
            mesh.bead(eye, joint(node), 0.11, 0.13, 0.16);
            break;
        case whisker_l:
        case whisker_r:
            add_whisker(mesh, s, detail);
            break;
        default:  // ears
            if (detail == Detail::coarse) break;
            mesh.blade(lacquer, joint(node) + Point{0, -0.10, 0.08}, joint(node) + Point{0, 0.12, 0.0},
                       joint(node) + Point{0.44 * s, 0.20, -0.42}, 0.08);
    }
}

}  // namespace scenes::hundred
