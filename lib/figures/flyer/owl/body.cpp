// Ruff, chest, belly, feet with talons, tail and wings, and their coarse levels.
#include <glm/geometric.hpp>

#include "lib/figures/flyer/owl/owl.h"

namespace claque::figures::flyer::owl
{

namespace
{

// Extends far down, for when the owl looks up.
const std::vector<Ring> ruff = {{{0, 0.110f, 0.000f}, 0.165f, 0.150f, 0.140f, -0.5f},
                                {{0, 0.200f, 0.000f}, 0.185f, 0.165f, 0.170f, 0.0f},
                                {{0, 0.255f, 0.000f}, 0.245f, 0.200f, 0.205f, 0.4f},
                                {{0, 0.330f, 0.000f}, 0.225f, 0.180f, 0.195f, 0.8f},
                                {{0, 0.370f, 0.000f}, 0.150f, 0.120f, 0.130f, 1.0f}};
const std::vector<Ring> chest = {
    {{0, -0.070f, 0.000f}, 0.230f, 0.215f, 0.200f, 0.0f}, {{0, -0.055f, 0.000f}, 0.282f, 0.262f, 0.240f, 0.1f},
    {{0, 0.030f, 0.000f}, 0.292f, 0.272f, 0.245f, 0.3f},  {{0, 0.140f, 0.000f}, 0.268f, 0.240f, 0.225f, 0.6f},
    {{0, 0.230f, 0.000f}, 0.215f, 0.190f, 0.190f, 0.9f},  {{0, 0.270f, 0.000f}, 0.120f, 0.110f, 0.110f, 1.0f}};
const std::vector<Ring> collar = {{{0, 0.168f, 0.000f}, 0.262f, 0.236f, 0.222f, 0.0f},
                                  {{0, 0.186f, 0.000f}, 0.270f, 0.244f, 0.230f, 0.5f},
                                  {{0, 0.206f, 0.000f}, 0.232f, 0.208f, 0.204f, 1.0f}};
const std::vector<Ring> belly = {{{0, -0.520f, -0.060f}, 0, 0, 0, 0.0f},
                                 {{0, -0.470f, -0.045f}, 0.120f, 0.105f, 0.090f, 0.2f},
                                 {{0, -0.330f, -0.015f}, 0.215f, 0.195f, 0.175f, 0.45f},
                                 {{0, -0.170f, 0.000f}, 0.270f, 0.250f, 0.225f, 0.7f},
                                 {{0, -0.040f, 0.000f}, 0.272f, 0.252f, 0.230f, 0.9f},
                                 {{0, 0.050f, 0.000f}, 0.200f, 0.180f, 0.170f, 1.0f}};

void add_foot(Mesh &mesh, int level, Side side)
{
    MeshBuilder to(mesh);
    const std::vector<Ring> leg = {{{0.112f, -0.560f, 0.070f}, 0.032f, 0.032f, 0.032f, 0.0f},
                                   {{0.112f, -0.500f, 0.062f}, 0.062f, 0.062f, 0.062f, 0.3f},
                                   {{0.112f, -0.390f, 0.045f}, 0.088f, 0.090f, 0.090f, 0.7f},
                                   {{0.112f, -0.310f, 0.020f}, 0.060f, 0.060f, 0.060f, 1.0f}};
    const int around = level == 0 ? 7 : level == 1 ? 5 : 3;
    add_tube(to, {foot_chart, side, around}, level < 2 ? leg : pick(leg, {0, 2}));
    if (level > 2) return;
    for (int i = -1; i <= 1; ++i) {
        if (level > 0 && i != 0) continue;
        const float aside = 0.034f * static_cast<float>(i), wide = level == 0 ? 0.016f : 0.040f;
        MeshBuilder claw(mesh);
        claw.spike(talon_chart, {mirrored({0.112f + aside - wide, -0.545f, 0.075f}, side),
                                 mirrored({0.112f + aside + wide, -0.545f, 0.075f}, side),
                                 mirrored({0.112f + aside, -0.590f, 0.060f}, side),
                                 mirrored({0.112f + 2.2f * aside, -0.635f, 0.150f}, side)});
    }
}

void add_letter(Mesh &mesh, int level)
{
    if (level > 1) return;
    MeshBuilder to(mesh);
    const glm::vec3 ex(0, 0, 1), ez(0, -1, 0);  // rolled up, it lies across
    const auto at = [](float x) { return glm::vec3(-0.112f + x, -0.622f, 0.090f); };
    const std::vector<Ring> rings = {{at(-0.172f), 0, 0, 0, 0.0f, ex, ez},
                                     {at(-0.170f), 0.036f, 0.036f, 0.036f, 0.1f, ex, ez},
                                     {at(0.170f), 0.036f, 0.036f, 0.036f, 0.9f, ex, ez},
                                     {at(0.172f), 0, 0, 0, 1.0f, ex, ez}};
    add_tube(to, {letter_chart, Side::left, level == 0 ? 7 : 4}, level == 0 ? rings : pick(rings, {1, 2}));
}

// A fan of feathers, visible from both sides.
void add_fan(Mesh &mesh, int level)
{
    const int feathers = level == 0 ? 5 : level == 1 ? 3 : 1;
    for (const float face : {1.0f, -1.0f}) {
        MeshBuilder to(mesh);
        std::vector<MeshBuilder::SheetVertex> tips, roots;
        const auto at = [&](float u, float c) {
            const float x = 2 * u - 1;
            const glm::vec3 p(x * (0.085f + 0.175f * c), -0.420f - c * (0.445f - 0.080f * x * x),
                              -0.090f - 0.085f * c - 0.020f * (1 - x * x) + face * 0.014f * (1 - c));
            return MeshBuilder::SheetVertex{p, glm::vec2(-c, u)};
        };
        for (int i = 0; i <= feathers; ++i) {
            const float u = static_cast<float>(i) / static_cast<float>(feathers),
                        step = 1 / static_cast<float>(feathers);
            if (level < 2 && i > 0) tips.push_back(at(u - step / 2, 1));
            tips.push_back(at(u, level < 2 && i > 0 && i < feathers ? 0.90f : 0.97f));
            roots.push_back(at(u, 0));
        }
        to.sheet(tail_chart, face > 0 ? Winding::reversed : Winding::as_given, {tips, roots});
    }
}

const Wing wing = {{0.150f, 0.190f, -0.110f}, {0.83f, 1.30f}, wing_back_chart, wing_front_chart};

}  // namespace

void add_ruff(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    add_tube(to, {ruff_chart, Side::left, level == 0 ? 11 : 6}, level == 0 ? ruff : pick(ruff, {0, 2, 4}));
}

void add_chest(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    add_tube(to,
             {chest_chart, Side::left,
              level == 0   ? 12
              : level == 1 ? 8
              : level == 2 ? 6
                           : 4},
             level < 2    ? chest
             : level == 2 ? pick(chest, {1, 3, 5})
                          : pick(chest, {1, 5}));
    if (level == 0) add_tube(to, {collar_chart, Side::left, 12}, collar);
    else if (level == 1) add_tube(to, {collar_chart, Side::left, 8}, pick(collar, {0, 2}));
}

void add_belly(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    add_tube(to,
             {belly_chart, Side::left,
              level == 0   ? 12
              : level == 1 ? 8
              : level == 2 ? 6
                           : 4},
             level == 0   ? belly
             : level == 1 ? pick(belly, {0, 1, 3, 4, 5})
             : level == 2 ? pick(belly, {0, 2, 4, 5})
                          : pick(belly, {0, 3, 5}));
}

void add_tail(Mesh &mesh, int level) { add_fan(mesh, level); }
void add_wing_left(Mesh &mesh, int level) { add_wing(mesh, wing, Side::left, level); }
void add_wing_right(Mesh &mesh, int level) { add_wing(mesh, wing, Side::right, level); }
void add_foot_left(Mesh &mesh, int level) { add_foot(mesh, level, Side::left); }

void add_foot_right(Mesh &mesh, int level)
{
    add_foot(mesh, level, Side::right);
    add_letter(mesh, level);
}

void add_bust(Mesh &mesh, int)
{
    add_far_head(mesh, 1);
    add_chest(mesh, 3);
}

void add_lower_half(Mesh &mesh, int)
{
    add_belly(mesh, 3);
    add_tail(mesh, 2);
    for (const Side side : {Side::left, Side::right}) add_foot(mesh, 3, side);
}

void add_whole(Mesh &mesh, int)
{
    MeshBuilder to(mesh);
    add_tube(to, {far_body_chart, Side::left, 3},
             {{{0, -0.860f, -0.150f}, 0, 0, 0, 0},
              {{0, -0.300f, 0}, 0.230f, 0.230f, 0.200f, 0.4f},
              {{0, 0.440f, 0}, 0.240f, 0.200f, 0.200f, 0.8f},
              {{0, 0.680f, 0}, 0, 0, 0, 1}});
    add_wing_left(mesh, 3);
    add_wing_right(mesh, 3);
}

}  // namespace claque::figures::flyer::owl
