// Head and neck as meridians: polylines from the neck to the crown, dense in the face, sparse at the back, joined by
// strips of triangles. The tables define the shape; paint_head.cpp paints it.
#include <cmath>

#include "lib/figures/parts.h"

namespace claque::figures
{

namespace
{

using Meridian = std::vector<glm::vec3>;

// From the middle of the face to the nape, left half; each starts at a point of the neckline.
constexpr std::array<size_t, 8> starts = {0, 1, 1, 2, 2, 2, 3, 4};

const std::array<Meridian, 8> meridians = {{
    {{0, 1.497f, 0.044f},
     {0, 1.517f, 0.082f},    // under the chin
     {0, 1.530f, 0.1025f},   // chin
     {0, 1.548f, 0.0960f},   // furrow below the lip
     {0, 1.557f, 0.1045f},   // lower lip
     {0, 1.5635f, 0.1005f},  // mouth
     {0, 1.571f, 0.1065f},   // upper lip
     {0, 1.583f, 0.1030f},   // below the nose
     {0, 1.589f, 0.1215f},
     {0, 1.597f, 0.1245f},  // tip
     {0, 1.617f, 0.1145f},  // bridge
     {0, 1.637f, 0.1015f},  // root of the nose
     {0, 1.653f, 0.1085f},  // between the brows
     {0, 1.690f, 0.1055f},
     {0, 1.714f, 0.0985f},  // hairline
     {0, 1.728f, 0.0940f},
     {0, 1.753f, 0.0520f}},
    {{0.022f, 1.499f, 0.042f},
     {0.019f, 1.519f, 0.079f},
     {0.019f, 1.532f, 0.0980f},
     {0.014f, 1.556f, 0.1005f},
     {0.015f, 1.5635f, 0.0975f},
     {0.012f, 1.5715f, 0.1035f},
     {0.0125f, 1.585f, 0.0990f},
     {0.0160f, 1.594f, 0.1055f},  // wing of the nose
     {0.0095f, 1.616f, 0.1040f},
     {0.0150f, 1.635f, 0.0900f},  // inner corner of the eye
     {0.0190f, 1.653f, 0.1040f},
     {0.021f, 1.690f, 0.1030f},
     {0.023f, 1.722f, 0.0940f},

     {0.025f, 1.751f, 0.0480f}},
    {{0.040f, 1.502f, 0.030f},
     {0.034f, 1.525f, 0.068f},
     {0.0335f, 1.538f, 0.0850f},
     {0.0265f, 1.5640f, 0.0880f},  // corner of the mouth
     {0.0285f, 1.589f, 0.0890f},
     {0.0310f, 1.616f, 0.0865f},   // below the eye
     {0.0315f, 1.6345f, 0.0895f},  // eye
     {0.0330f, 1.655f, 0.0985f},   // brow
     {0.037f, 1.690f, 0.0950f},
     {0.040f, 1.722f, 0.0840f},

     {0.040f, 1.747f, 0.0430f}},
    {{0.0500f, 1.504f, 0.014f},
     {0.0460f, 1.532f, 0.052f},
     {0.0500f, 1.564f, 0.0670f},
     {0.0560f, 1.602f, 0.0745f},  // cheekbone
     {0.0480f, 1.634f, 0.0790f},  // outer corner of the eye
     {0.0530f, 1.654f, 0.0820f},
     {0.0580f, 1.690f, 0.0745f},
     {0.0570f, 1.716f, 0.0650f},
     {0.0520f, 1.738f, 0.0360f}},
    {{0.0560f, 1.498f, -0.012f},
     {0.0570f, 1.530f, 0.010f},  // angle of the jaw
     {0.0650f, 1.566f, 0.026f},
     {0.0700f, 1.608f, 0.041f},
     {0.0695f, 1.648f, 0.047f},  // temple
     {0.0730f, 1.692f, 0.040f},
     {0.0590f, 1.732f, 0.020f}},
    {{0.0550f, 1.506f, -0.038f},
     {0.0600f, 1.556f, -0.018f},
     {0.0730f, 1.600f, -0.008f},
     {0.0775f, 1.648f, -0.006f},
     {0.0760f, 1.694f, -0.008f},
     {0.0550f, 1.737f, -0.010f}},
    {{0.0410f, 1.525f, -0.062f},
     {0.0560f, 1.572f, -0.068f},
     {0.0680f, 1.636f, -0.074f},
     {0.0620f, 1.698f, -0.068f},
     {0.0430f, 1.738f, -0.046f}},
    {{0, 1.530f, -0.072f}, {0, 1.570f, -0.086f}, {0, 1.634f, -0.106f}, {0, 1.697f, -0.096f}, {0, 1.740f, -0.060f}},
}};
const glm::vec3 head_crown(0, 1.7585f, -0.006f);

// 0 in the middle of the face, 0.5 at the nape: like the angle, but with most of the range for the face. Uses divisions
// only, so that it is the same on every processor.
float around_head(glm::vec3 p)
{
    const float x = std::fabs(p.x), z = p.z + 0.03f;
    float quarters = 0;
    if (z > 0 && x <= z) quarters = x / z;
    else if (x >= std::fabs(z)) quarters = 2 - z / x;
    else quarters = 4 - x / -z;
    return quarters <= 1 ? 0.33f * quarters : 0.33f + 0.17f / 3 * (quarters - 1);
}

// Maps heights with less range for the neck, and for the hair where the surface turns inwards.
float upwards(glm::vec3 p)
{
    const float neck = 1.50f, top = 1.70f;
    if (p.y < neck) return neck - 0.4f * (neck - p.y);
    if (p.y < top) return p.y;
    const float across = 0.09f - std::sqrt(p.x * p.x + p.z * p.z);
    return top + 0.7f * (p.y - top) + 0.35f * (across > 0 ? across : 0);
}

void add_ear(Mesh &mesh, Side side)
{
    const std::array<glm::vec3, 8> table = {{{0.0690f, 1.586f, 0.003f},
                                             {0.0810f, 1.600f, -0.012f},
                                             {0.0890f, 1.628f, -0.022f},
                                             {0.0870f, 1.650f, -0.014f},
                                             {0.0755f, 1.652f, 0.007f},
                                             {0.0775f, 1.619f, -0.005f},  // the hollow
                                             {0.0660f, 1.598f, -0.028f},  // behind, inside the head
                                             {0.0680f, 1.648f, -0.030f}}};
    std::array<Corner, 8> c;
    for (size_t i = 0; i < table.size(); ++i)
        c[i] = {mesh.add(mirrored(table[i], side), Region::head, side), glm::vec2(-table[i].z, table[i].y)};
    c[6].st = glm::vec2(0.045f, 1.600f), c[7].st = glm::vec2(0.045f, 1.648f);
    const Chart chart = on(side, Chart::ear);
    const Winding winding = winding_of(side);
    for (const auto &f : std::vector<std::array<int, 3>>{
             {0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 0, 5}, {1, 6, 2}, {6, 7, 2}, {7, 3, 2}})
        mesh.face(chart, winding, c[static_cast<size_t>(f[0])], c[static_cast<size_t>(f[1])],
                  c[static_cast<size_t>(f[2])]);
}

}  // namespace

void add_head(Mesh &mesh)
{
    const uint32_t top = mesh.add(head_crown, Region::head);
    // The right half first, mirrored, then the left; they share the middle meridians.
    std::array<std::array<Chain, 8>, 2> halves;
    const auto add = [&](size_t m, glm::vec3 p, Region region) {
        const uint32_t left = mesh.add(p, region);
        const uint32_t right = p.x == 0 ? left : mesh.add(mirrored(p, Side::right), region, Side::right);
        halves[0][m].push_back({left, glm::vec2(around_head(p), upwards(p))});
        halves[1][m].push_back({right, glm::vec2(-around_head(p), upwards(p))});
    };
    for (size_t m = 0; m < meridians.size(); ++m) {
        if (m > 0 && starts[m] == starts[m - 1])
            for (auto &half : halves) half[m].push_back(half[m - 1].front());
        else add(m, neckline[starts[m]], Region::torso);  // moves with the cloth
        for (const glm::vec3 &p : meridians[m]) add(m, p, Region::head);
    }
    for (const Side side : {Side::left, Side::right}) {
        auto &half = halves[side == Side::left ? 0 : 1];
        for (size_t m = 0; m + 1 < half.size(); ++m) {
            const float s = (half[m].back().st.x + half[m + 1].back().st.x) / 2;
            const Corner corner = {top, glm::vec2(s, upwards(head_crown))};
            Chain a = half[m], b = half[m + 1];
            mesh.face(Chart::head, winding_of(side), a.back(), b.back(), corner);
            mesh.sew(Chart::head, side == Side::left ? Winding::reversed : Winding::as_given, a, b, Along::t);
        }
    }
    add_ear(mesh, Side::left);
    add_ear(mesh, Side::right);
}

}  // namespace claque::figures
