// A broad head with two facial discs, beak and tufts.
#include <cmath>

#include <glm/geometric.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/flyer/owl/owl.h"
#include "lib/math/trig.h"

namespace claque::figures::flyer::owl
{

namespace
{

constexpr float half_turn = 3.14159265f, crown = 0.200f;

glm::vec3 on_head(float angle, float height)
{
    const float k = std::fabs(height) / 0.205f;
    const float r = math::pow(std::max(0.0f, 1 - math::pow(k, 2.4f)), 1 / 2.4f);
    const float sx = math::sin(angle), cz = math::cos(angle);
    glm::vec3 q(0.235f * r * sx, height, (cz > 0 ? 0.180f : 0.190f) * r * cz);
    if (cz > 0) {
        const glm::vec2 f(std::fabs(q.x), q.y);
        q.z -= 0.038f * spot(f, {0.098f, 0.015f}, {0.125f, 0.135f});
        q.z += 0.024f * spot(f, {0, 0.040f}, {0.060f, 0.150f});
    }
    return head_centre + q;
}

struct Meridian {
    float angle;
    std::vector<float> heights;
};
const std::vector<Meridian> fine = {
    {0, {-0.170f, -0.090f, -0.030f, 0.030f, 0.090f, 0.140f, 0.180f}},
    {0.25f, {-0.170f, -0.100f, -0.030f, 0.030f, 0.090f, 0.150f}},
    {0.50f, {-0.170f, -0.110f, -0.050f, 0.015f, 0.080f, 0.135f, 0.180f}},
    {0.80f, {-0.170f, -0.110f, -0.030f, 0.060f, 0.130f}},
    {1.15f, {-0.170f, -0.060f, 0.060f, 0.145f, 0.182f}},
    {1.70f, {-0.160f, 0.000f, 0.120f}},
    {2.40f, {-0.170f, -0.050f, 0.080f, 0.170f}},
    {half_turn, {-0.170f, -0.030f, 0.100f, 0.180f}},
};
const std::vector<Meridian> medium = {
    {0, {-0.170f, -0.060f, 0.050f, 0.140f}}, {0.50f, {-0.170f, -0.070f, 0.015f, 0.100f, 0.175f}},
    {0.95f, {-0.170f, -0.040f, 0.110f}},     {1.70f, {-0.170f, 0.000f, 0.140f}},
    {half_turn, {-0.170f, -0.030f, 0.150f}},
};
const std::vector<Meridian> coarse = {{0, {-0.170f, 0.020f, 0.150f}},
                                      {0.80f, {-0.170f, 0.000f, 0.140f}},
                                      {1.70f, {-0.170f, 0.000f, 0.150f}},
                                      {half_turn, {-0.170f, 0.130f}}};
const std::vector<Meridian> coarsest = {
    {0, {-0.170f, 0.120f}}, {1.40f, {-0.170f, 0.120f}}, {half_turn, {-0.170f, 0.120f}}};

void add_skull(MeshBuilder &to, Chart chart, const std::vector<Meridian> &half, float swell)
{
    std::vector<std::vector<MeshBuilder::SheetVertex>> meridians;
    const auto add = [&](const Meridian &m, float side) {
        std::vector<MeshBuilder::SheetVertex> stops;
        for (const float h : m.heights) {
            const glm::vec3 p = on_head(m.angle, h);
            stops.push_back(
                {glm::vec3(side * swell * (m.angle > 3 ? 0 : p.x), p.y, swell * p.z), glm::vec2(side * m.angle, h)});
        }
        stops.push_back({head_centre + glm::vec3(0, crown, 0), glm::vec2(side * m.angle, crown)});
        meridians.push_back(stops);
    };
    for (size_t m = half.size(); m-- > 1;) add(half[m], -1);
    for (const Meridian &m : half) add(m, 1);
    to.sheet(chart, Winding::as_given, meridians);
}

// Tufts over the outer ends of the discs.
void add_tuft_pair(Mesh &mesh)
{
    for (const Side side : {Side::left, Side::right}) {
        MeshBuilder to(mesh);
        to.spike(tuft_chart, {mirrored({0.020f, 0.560f, 0.205f}, side), mirrored({0.165f, 0.575f, 0.135f}, side),
                              mirrored({0.120f, 0.610f, 0.050f}, side), mirrored({0.245f, 0.745f, 0.030f}, side)});
    }
}

void add_eye(Mesh &mesh, int level, Side side)
{
    MeshBuilder to(mesh);
    add_ball(to, eye_chart, {mirrored(eye_left, side), eye_radius * (level == 0 ? 1 : 1.06f), 1.20f, 1.20f},
             level == 0 ? 6 : 3, level == 0 ? 4 : 2);
}

void add_upper_beak(Mesh &mesh)
{
    MeshBuilder to(mesh);
    const glm::vec3 top(0, 0.510f, 0.185f), tip(0, 0.385f, 0.250f), under(0, 0.430f, 0.150f),
        left(0.042f, 0.445f, 0.160f);
    to.spike(beak_chart, {top, under, left, tip});
    to.spike(beak_chart, {top, mirrored(left, Side::right), under, tip});
}

}  // namespace

void add_head(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    add_skull(to, head_chart, level == 0 ? fine : medium, level == 0 ? 1 : 1.02f);
    add_upper_beak(mesh);
}

void add_far_head(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    add_skull(to, far_head_chart, level == 0 ? coarse : coarsest, level == 0 ? 1.04f : 1.10f);
    if (level == 0) add_upper_beak(mesh);
    add_tuft_pair(mesh);
}

void add_eye_left(Mesh &mesh, int level) { add_eye(mesh, level, Side::left); }
void add_eye_right(Mesh &mesh, int level) { add_eye(mesh, level, Side::right); }

void add_lids(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    const std::vector<float> pitches = level == 0 ? std::vector<float>{0.50f, 1.00f, 1.75f} : std::vector{0.50f, 1.75f};
    for (const Side side : {Side::left, Side::right})
        add_lid(to, lid_chart, {mirrored(eye_left, side), eye_radius + 0.0040f, 1.35f, 0}, level == 0 ? 6 : 3, pitches);
}

void add_beak(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    const glm::vec3 left(0.030f, 0.437f, 0.160f), right(-0.030f, 0.437f, 0.160f), tip(0, 0.390f, 0.228f);
    const glm::vec3 below(0, 0.400f, 0.160f);
    if (level == 0) to.spike(beak_chart, {left, below, right, tip});
    else to.triangle(beak_chart, Winding::as_given, {left, {0, 0}}, {below, {1, 0}}, {tip, {0.5f, 1}});
}

void add_tufts(Mesh &mesh, int level)
{
    add_tuft_pair(mesh);
    if (level > 0) return;
    for (const Side side : {Side::left, Side::right}) {
        MeshBuilder to(mesh);
        to.spike(tuft_chart, {mirrored({0.110f, 0.575f, 0.150f}, side), mirrored({0.185f, 0.560f, 0.110f}, side),
                              mirrored({0.150f, 0.600f, 0.040f}, side), mirrored({0.285f, 0.675f, 0.030f}, side)});
    }
}

}  // namespace claque::figures::flyer::owl
