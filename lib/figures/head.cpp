// Head and neck as meridians: polylines from the neck to the crown, dense in the face, sparse at the back, zipped
// together. The tables are the sculpture; what is painted on it is in paint_head.cpp.
#include <cmath>

#include "lib/figures/parts.h"

namespace claque::figures
{

namespace
{

using Meridian = std::vector<glm::vec3>;

// From the middle of the face to the nape, left half.
const std::array<Meridian, 8> meridians = {{
    {{0, 1.405f, 0.046f},
     {0, 1.497f, 0.046f},
     {0, 1.517f, 0.086f},    // under the chin
     {0, 1.530f, 0.104f},    // chin
     {0, 1.548f, 0.097f},    // furrow below the lip
     {0, 1.557f, 0.106f},    // lower lip
     {0, 1.5635f, 0.1015f},  // mouth
     {0, 1.571f, 0.1075f},   // upper lip
     {0, 1.583f, 0.103f},    // below the nose
     {0, 1.592f, 0.129f},    // tip
     {0, 1.616f, 0.117f},    // bridge
     {0, 1.637f, 0.1025f},   // root of the nose
     {0, 1.653f, 0.109f},    // between the brows
     {0, 1.690f, 0.106f},
     {0, 1.713f, 0.101f},  // hairline
     {0, 1.730f, 0.099f},
     {0, 1.750f, 0.062f}},
    {{0.026f, 1.405f, 0.040f},
     {0.022f, 1.499f, 0.044f},
     {0.019f, 1.519f, 0.083f},
     {0.019f, 1.532f, 0.099f},
     {0.014f, 1.556f, 0.1015f},
     {0.015f, 1.5635f, 0.0985f},
     {0.012f, 1.5715f, 0.1045f},
     {0.013f, 1.584f, 0.100f},
     {0.0165f, 1.592f, 0.106f},  // wing of the nose
     {0.0095f, 1.615f, 0.105f},
     {0.0150f, 1.635f, 0.0905f},  // inner corner of the eye
     {0.0190f, 1.653f, 0.105f},
     {0.021f, 1.690f, 0.104f},
     {0.022f, 1.714f, 0.099f},
     {0.023f, 1.730f, 0.096f},
     {0.026f, 1.749f, 0.058f}},
    {{0.046f, 1.41f, 0.022f},
     {0.040f, 1.503f, 0.036f},
     {0.036f, 1.525f, 0.071f},
     {0.035f, 1.538f, 0.086f},
     {0.0265f, 1.5635f, 0.0885f},  // corner of the mouth
     {0.0290f, 1.588f, 0.0890f},
     {0.0310f, 1.616f, 0.0865f},   // below the eye
     {0.0315f, 1.6345f, 0.0895f},  // eye
     {0.0330f, 1.655f, 0.0985f},   // brow
     {0.037f, 1.690f, 0.096f},
     {0.039f, 1.715f, 0.089f},
     {0.041f, 1.730f, 0.085f},
     {0.043f, 1.746f, 0.052f}},
    {{0.060f, 1.415f, -0.005f},
     {0.050f, 1.511f, 0.026f},
     {0.049f, 1.533f, 0.058f},
     {0.052f, 1.566f, 0.0680f},
     {0.0560f, 1.602f, 0.0745f},  // cheekbone
     {0.0480f, 1.634f, 0.0790f},  // outer corner of the eye
     {0.0530f, 1.654f, 0.0820f},
     {0.058f, 1.690f, 0.076f},
     {0.060f, 1.714f, 0.070f},
     {0.059f, 1.736f, 0.045f}},
    {{0.064f, 1.42f, -0.030f},
     {0.0600f, 1.529f, 0.012f},  // angle of the jaw
     {0.0665f, 1.565f, 0.028f},
     {0.0700f, 1.608f, 0.042f},
     {0.0695f, 1.648f, 0.048f},  // temple
     {0.0755f, 1.694f, 0.042f},
     {0.066f, 1.730f, 0.026f}},
    {{0.060f, 1.43f, -0.058f},
     {0.0600f, 1.545f, -0.022f},
     {0.0735f, 1.600f, -0.006f},
     {0.0785f, 1.648f, -0.004f},
     {0.0790f, 1.694f, -0.006f},
     {0.062f, 1.735f, -0.008f}},
    {{0.042f, 1.44f, -0.088f},
     {0.046f, 1.535f, -0.063f},
     {0.060f, 1.572f, -0.068f},
     {0.070f, 1.636f, -0.074f},
     {0.065f, 1.696f, -0.070f},
     {0.048f, 1.736f, -0.048f}},
    {{0, 1.445f, -0.098f},
     {0, 1.538f, -0.073f},
     {0, 1.570f, -0.086f},
     {0, 1.634f, -0.107f},
     {0, 1.696f, -0.099f},
     {0, 1.738f, -0.062f}},
}};
const glm::vec3 crown(0, 1.757f, -0.006f);

// 0 in the middle of the face, 0.5 at the nape: like the angle, but with most of the room for the face, and made of
// divisions only.
float around(glm::vec3 p)
{
    const float x = std::fabs(p.x), z = p.z + 0.03f;
    float quarters = 0;
    if (z > 0 && x <= z) quarters = x / z;
    else if (x >= std::fabs(z)) quarters = 2 - z / x;
    else quarters = 4 - x / -z;
    return quarters <= 1 ? 0.33f * quarters : 0.33f + 0.17f / 3 * (quarters - 1);
}

// Heights, with less room for the neck, and for the hair where the surface turns inwards.
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
    const std::array<glm::vec3, 8> table = {{{0.0770f, 1.590f, 0.004f},
                                             {0.0855f, 1.602f, -0.013f},
                                             {0.0955f, 1.630f, -0.023f},
                                             {0.0935f, 1.652f, -0.012f},
                                             {0.0760f, 1.645f, 0.008f},
                                             {0.0790f, 1.618f, -0.004f},  // the hollow
                                             {0.0680f, 1.600f, -0.028f},  // behind, inside the head
                                             {0.0700f, 1.648f, -0.030f}}};
    std::array<Corner, 8> c;
    for (size_t i = 0; i < table.size(); ++i)
        c[i] = {mesh.add(mirrored(table[i], side), Region::head, side), glm::vec2(-table[i].z, table[i].y)};
    c[6].st = glm::vec2(0.045f, 1.600f), c[7].st = glm::vec2(0.045f, 1.648f);
    const Chart chart = on(side, Chart::ear);
    const Winding winding = winding_of(side);
    for (const auto &f : std::vector<std::array<int, 3>>{
             {0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 0, 5}, {1, 6, 2}, {6, 7, 2}, {7, 3, 2}})
        mesh.face(chart, winding, c[static_cast<size_t>(f[0])], c[static_cast<size_t>(f[2])],
                  c[static_cast<size_t>(f[1])]);
}

}  // namespace

void add_head(Mesh &mesh)
{
    const uint32_t top = mesh.add(crown, Region::head);
    // The right half first, mirrored, then the left; the middle ones are shared.
    std::array<std::array<Chain, 8>, 2> halves;
    for (size_t m = 0; m < meridians.size(); ++m)
        for (const glm::vec3 p : meridians[m]) {
            const bool middle = m == 0 || m == 7;
            const uint32_t left = mesh.add(p, Region::head);
            const uint32_t right = middle ? left : mesh.add(mirrored(p, Side::right), Region::head);
            halves[0][m].push_back({left, glm::vec2(around(p), upwards(p))});
            halves[1][m].push_back({right, glm::vec2(-around(p), upwards(p))});
        }
    for (const Side side : {Side::left, Side::right}) {
        auto &half = halves[side == Side::left ? 0 : 1];
        for (size_t m = 0; m + 1 < half.size(); ++m) {
            const float s = (half[m].back().st.x + half[m + 1].back().st.x) / 2;
            const Corner corner = {top, glm::vec2(s, upwards(crown))};
            Chain a = half[m], b = half[m + 1];
            mesh.face(Chart::head, winding_of(side), a.back(), b.back(), corner);
            mesh.sew(Chart::head, side == Side::left ? Winding::reversed : Winding::as_given, a, b, Along::t);
        }
    }
    add_ear(mesh, Side::left);
    add_ear(mesh, Side::right);
}

}  // namespace claque::figures
