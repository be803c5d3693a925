// The head with its wreath, and the moving parts of the face.
#include <cmath>

#include <glm/geometric.hpp>

#include "lib/figures/flyer/herald/herald.h"

namespace claque::figures::flyer::herald
{

namespace
{

struct Meridian {
    float angle;
    std::vector<float> heights;
};

// The left half, from the middle of the face to the nape; the crown closes the meridians.
const std::vector<Meridian> fine = {
    {0,
     {-0.142f, -0.077f, -0.0725f, -0.062f, -0.0525f, -0.044f, -0.031f, 0.000f, 0.038f, 0.060f, 0.084f, 0.112f, 0.129f}},
    {0.15f, {-0.142f, -0.077f, -0.0725f, -0.062f, -0.050f, -0.040f, -0.020f, 0.010f, 0.042f, 0.086f}},
    {0.27f, {-0.142f, -0.077f, -0.0725f, -0.045f, -0.008f, 0.018f, 0.044f, 0.088f}},
    {0.44f, {-0.142f, -0.077f, -0.0725f, -0.040f, -0.008f, 0.009f, 0.028f, 0.047f, 0.084f, 0.112f}},
    {0.66f, {-0.142f, -0.118f, -0.074f, -0.032f, -0.002f, 0.018f, 0.042f, 0.074f}},
    {0.92f, {-0.142f, -0.115f, -0.070f, -0.020f, 0.030f, 0.050f, 0.112f}},
    {1.25f, {-0.142f, -0.080f, -0.040f, 0.030f, 0.090f, 0.127f}},
    {1.70f, {-0.142f, -0.030f, 0.060f, 0.114f}},
    {2.40f, {-0.142f, -0.085f, -0.010f, 0.075f, 0.110f, 0.128f}},
    {3.14159265f, {-0.142f, -0.095f, -0.040f, 0.050f, 0.110f}},
};
const std::vector<Meridian> medium = {
    {0, {-0.146f, -0.0745f, -0.0715f, -0.047f, -0.030f, 0.040f, 0.086f, 0.118f}},
    {0.27f, {-0.146f, -0.0745f, -0.045f, -0.010f, 0.018f, 0.048f, 0.088f}},
    {0.66f, {-0.146f, -0.100f, -0.040f, 0.018f, 0.048f, 0.074f, 0.116f}},
    {1.20f, {-0.146f, -0.075f, 0.000f, 0.070f}},
    {1.80f, {-0.146f, -0.020f, 0.080f, 0.120f}},
    {3.14159265f, {-0.146f, -0.090f, 0.020f, 0.110f}},
};
const std::vector<Meridian> coarse = {
    {0, {-0.146f, -0.112f, -0.044f, -0.030f, 0.030f, 0.110f}},
    {0.50f, {-0.146f, -0.095f, 0.020f, 0.084f}},
    {1.10f, {-0.146f, -0.060f, 0.055f, 0.112f}},
    {2.00f, {-0.146f, -0.040f, 0.090f}},
    {3.14159265f, {-0.146f, -0.080f, 0.040f, 0.110f}},
};
const std::vector<Meridian> coarsest = {
    {0, {-0.140f, -0.100f, 0.090f}}, {1.20f, {-0.140f, 0.000f, 0.095f}}, {3.14159265f, {-0.140f, 0.010f, 0.095f}}};

constexpr float crown = 0.137f;

// Enlarged to make up for what coarse meridians cut off.
void add_skull(MeshBuilder &to, Chart chart, Sculpt sculpt, const std::vector<Meridian> &half, float swell)
{
    std::vector<std::vector<MeshBuilder::SheetVertex>> meridians;
    const auto add = [&](const Meridian &m, float side) {
        std::vector<MeshBuilder::SheetVertex> stops;
        for (const float h : m.heights) {
            const glm::vec3 p = on_head(m.angle, h, sculpt);
            stops.push_back({glm::vec3(side * swell * (m.angle > 3 ? 0 : p.x), p.y, swell * p.z),
                             glm::vec2(side * s_of(m.angle), h)});
        }
        const glm::vec3 top = on_head(0, crown, sculpt) + glm::vec3(0, 0.001f, -0.020f);
        stops.push_back({top, glm::vec2(side * s_of(m.angle), crown)});
        meridians.push_back(stops);
    };
    for (size_t m = half.size(); m-- > 1;) add(half[m], -1);
    for (const Meridian &m : half) add(m, 1);
    to.sheet(chart, Winding::as_given, meridians);
}

// Leaves of a wreath over the temples: each is a small roof with the hair as its underside.
void add_wreath(MeshBuilder &to, int level)
{
    const int leaves = level == 0 ? 4 : 3;
    for (const Side side : {Side::left, Side::right})
        for (int i = 0; i < leaves; ++i) {
            const float from = 0.35f + 1.5f * static_cast<float>(i) / static_cast<float>(leaves);
            const float until = from + 2.1f / static_cast<float>(leaves);
            const float h = 0.094f - 0.050f * from / 1.5f;
            const auto on = [&](float angle, float height, float off) {
                const glm::vec3 p = on_head(angle, height, Sculpt::far);
                const glm::vec3 outward = glm::normalize(p - head_centre);
                return mirrored(p + outward * off, side);
            };
            const MeshBuilder::SheetVertex root = {on(until, h - 0.020f, 0.000f), {0, 0.5f}};
            const MeshBuilder::SheetVertex tip = {on(from, h + 0.012f, 0.014f), {1, 0.5f}};
            const MeshBuilder::SheetVertex low = {on((from + until) / 2, h - 0.022f, 0.000f), {0.5f, 0}};
            const MeshBuilder::SheetVertex high = {on((from + until) / 2, h + 0.014f, 0.000f), {0.5f, 1}};
            const MeshBuilder::SheetVertex rib = {on((from + until) / 2, h - 0.004f, 0.010f), {0.5f, 0.5f}};
            const Winding w = winding_of(side);
            if (level > 0) {
                to.triangle(wreath_chart, w, tip, low, root);
                to.triangle(wreath_chart, w, tip, root, high);
                continue;
            }
            to.triangle(wreath_chart, w, tip, low, rib);
            to.triangle(wreath_chart, w, low, root, rib);
            to.triangle(wreath_chart, w, root, high, rib);
            to.triangle(wreath_chart, w, high, tip, rib);
        }
}

void add_eye(Mesh &mesh, int level, Side side)
{
    MeshBuilder to(mesh);
    add_ball(to, eye_chart, {mirrored(eye_left, side), eye_radius * (level == 0 ? 1 : 1.06f), 1.05f, 1.0f},
             level == 0 ? 5 : 2, level == 0 ? 3 : 2);
}

}  // namespace

void add_head(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    add_skull(to, head_chart, Sculpt::near, level == 0 ? fine : medium, level == 0 ? 1 : 1.02f);
    add_wreath(to, level);
}

void add_far_head(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    add_skull(to, far_head_chart, Sculpt::far, level == 0 ? coarse : coarsest, level == 0 ? 1.05f : 1.12f);
}

void add_eye_left(Mesh &mesh, int level) { add_eye(mesh, level, Side::left); }
void add_eye_right(Mesh &mesh, int level) { add_eye(mesh, level, Side::right); }

void add_lids(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    const std::vector<float> pitches = level == 0 ? std::vector<float>{0.42f, 1.00f, 1.75f} : std::vector{0.42f, 1.75f};
    for (const Side side : {Side::left, Side::right})
        add_lid(to, lid_chart, {mirrored(eye_left, side), eye_radius + 0.0020f, 1.35f, 0}, level == 0 ? 5 : 2, pitches);
}

void add_jaw(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    const std::vector<float> angles =
        level == 0 ? std::vector<float>{-0.65f, -0.62f, -0.40f, -0.15f, 0.15f, 0.40f, 0.62f, 0.65f}
                   : std::vector<float>{-0.65f, -0.62f, -0.25f, 0.25f, 0.62f, 0.65f};
    const std::vector<float> heights = level == 0 ? std::vector<float>{-0.140f, -0.117f, -0.092f, -0.0745f}
                                                  : std::vector<float>{-0.142f, -0.108f, -0.0745f};
    std::vector<std::vector<MeshBuilder::SheetVertex>> skin, mouth;
    for (const float angle : angles) {
        std::vector<MeshBuilder::SheetVertex> stops;
        const bool rim = angle == angles.front() || angle == angles.back();  // turned in, so that no gap opens
        for (const float h : heights) {
            glm::vec3 p = on_head(angle, h, Sculpt::jaw);
            if (rim) p -= glm::vec3(0.4f * (p.x - head_centre.x), 0, 0.018f);
            stops.push_back({p, glm::vec2(angle, h)});
        }
        skin.push_back(stops);
        if (rim) continue;
        glm::vec3 inside = stops.back().first;
        inside.x *= 0.7f, inside.z = head_centre.z + 0.030f, inside.y -= 0.004f;
        mouth.push_back({{stops.back().first, glm::vec2(angle, 0)}, {inside, glm::vec2(angle, 1)}});
    }
    to.sheet(jaw_chart, Winding::as_given, {skin.begin() + 1, skin.end() - 1});
    MeshBuilder rims(mesh);
    rims.sheet(jaw_chart, Winding::as_given, {skin[0], skin[1]});
    rims.sheet(jaw_chart, Winding::as_given, {skin[skin.size() - 2], skin.back()});
    MeshBuilder(mesh).sheet(mouth_chart, Winding::as_given, mouth);  // with an edge between lip and mouth
}

void add_brow(Mesh &mesh, int level)
{
    MeshBuilder to(mesh);
    const int n = level == 0 ? 2 : 1;
    const float lift = level == 0 ? 0 : 0.004f;  // above coarser foreheads
    for (const Side side : {Side::left, Side::right}) {
        std::vector<std::vector<MeshBuilder::SheetVertex>> meridians;
        for (int i = 0; i <= n; ++i) {
            const float s = static_cast<float>(i) / static_cast<float>(n), angle = 0.16f + s * 0.60f;
            const float middle = 0.0500f + 0.0085f * (1 - (2 * s - 0.9f) * (2 * s - 0.9f));
            const float half = 0.0052f - 0.0032f * s;
            const auto at = [&](float h, float off) {
                const glm::vec3 p = on_head(angle, h, Sculpt::far);
                return mirrored(p + glm::normalize(glm::vec3(p.x, 0, p.z)) * (off + lift), side);
            };
            meridians.push_back({{at(middle - half, 0.0005f), {s, 0}},
                                 {at(middle, 0.0065f), {s, 0.5f}},
                                 {at(middle + half, 0.0005f), {s, 1}}});
        }
        to.sheet(brow_chart, winding_of(side), meridians);
    }
}

}  // namespace claque::figures::flyer::herald
