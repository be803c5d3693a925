// Makes a woman's head from the shared one: narrower jaw, neck and nose, a shorter chin, fuller lips. The scalp is
// raised to the high hairdress of the Flavian court, a bank of curls over the brow and a coiled bun behind. With
// earrings.
#include <cmath>

#include "lib/figures/brush.h"
#include "lib/figures/patrician/patrician.h"
#include "lib/math/trig.h"

namespace claque::figures::patrician
{

namespace
{

// The part of the face below the eyes is a little shorter.
float height(glm::vec3 p)
{
    static const glm::vec2 heights[] = {{1.490f, 1.490f},
                                        {1.517f, 1.5250f},
                                        {1.530f, 1.5375f},
                                        {1.5635f, 1.5680f},
                                        {1.5970f, 1.6005f},
                                        {1.6345f, 1.6345f},
                                        {2, 2}};
    const float ahead = smoothstep(-0.03f, 0.05f, p.z);
    return p.y + (profile(heights, p.y) - p.y) * ahead;
}

glm::vec3 womans(glm::vec3 p)
{
    const float x = std::fabs(p.x), nose = spot(glm::vec2(x, p.y), {0, 1.598f}, {0.034f, 0.040f});
    glm::vec3 q = p;
    q.x *= 0.965f * (1 - 0.23f * smoothstep(1.612f, 1.538f, p.y) * smoothstep(-0.03f, 0.04f, p.z));
    if (p.z > 0.098f && x < 0.020f && p.y > 1.58f && p.y < 1.63f) q.x *= 0.84f;  // wings of the nose
    if (x < 0.013f) q.z -= 0.0065f * nose * smoothstep(0.100f, 0.122f, p.z);
    q.z -= 0.0030f * spot(glm::vec2(x, p.y), {0.012f, 1.655f}, {0.040f, 0.020f});  // no ridge over the eyes
    q.z += 0.0020f * spot(glm::vec2(x, p.y), {0.045f, 1.600f}, {0.030f, 0.030f});  // full cheeks
    q.z += 0.0016f * spot(glm::vec2(x, p.y), {0, 1.564f}, {0.024f, 0.014f});       // and lips
    q.z -= 0.0050f * spot(glm::vec2(x, p.y), {0, 1.528f}, {0.050f, 0.024f});       // small chin
    q.y = height(p);
    const float neck = smoothstep(1.560f, 1.505f, p.y + 0.45f * p.z);  // the nape reaches higher than the throat
    q.x *= 1 - 0.24f * neck;
    return q;
}

// Raises the scalp: highest over the brow, wide over the temples, drawn back tight behind.
glm::vec3 dressed(glm::vec3 p)
{
    const float hair = smoothstep(1.694f, 1.724f, p.y + 0.35f * std::max(0.0f, 0.055f - p.z));
    const float front = smoothstep(-0.030f, 0.045f, p.z);
    const float top = smoothstep(1.728f, 1.746f, p.y);
    glm::vec3 q = p;
    q.y += hair * front * (0.018f + 0.013f * top) + hair * (1 - front) * 0.012f;
    q.y += 0.013f * hair * top * spot(p.x, 0.060f);
    q.z += hair * front * (0.007f - 0.004f * top);
    q.x *= 1 + hair * (0.06f + front * (0.10f - 0.03f * top));
    const float temple =
        spot(glm::vec2(p.z, p.y), {0.010f, 1.668f}, {0.060f, 0.050f}) * smoothstep(0.05f, 0.07f, std::fabs(p.x));
    q.x *= 1 + 0.10f * temple;
    return q;
}

// Points of the shared head under the chin and their positions here: a clear edge of the jaw, a slender throat, the pit
// between the collar bones.
struct Moved {
    glm::vec3 from, to;
};
const std::array<Moved, 13> throat = {{
    {{0, 1.497f, 0.044f}, {0, 1.466f, 0.044f}},
    {{0.022f, 1.499f, 0.042f}, {0.022f, 1.468f, 0.040f}},
    {{0.040f, 1.502f, 0.030f}, {0.038f, 1.474f, 0.024f}},
    {{0.0500f, 1.504f, 0.014f}, {0.0410f, 1.482f, 0.006f}},
    {{0, 1.517f, 0.082f}, {0, 1.520f, 0.046f}},
    {{0.019f, 1.519f, 0.079f}, {0.018f, 1.521f, 0.045f}},
    {{0.034f, 1.525f, 0.068f}, {0.031f, 1.527f, 0.042f}},
    {{0, 1.530f, 0.1025f}, {0, 1.5315f, 0.0975f}},
    {{0.019f, 1.532f, 0.0980f}, {0.016f, 1.5325f, 0.0940f}},
    {{0.0335f, 1.538f, 0.0850f}, {0.0285f, 1.5400f, 0.0805f}},
    {{0.0460f, 1.532f, 0.052f}, {0.0385f, 1.539f, 0.050f}},
    {{0.0560f, 1.498f, -0.012f}, {0.0425f, 1.490f, -0.016f}},
    {{0.0570f, 1.530f, 0.010f}, {0.0490f, 1.540f, 0.010f}},
}};

// Small and close to the head; hair covers the upper rim.
glm::vec3 small_ear(glm::vec3 p)
{
    const glm::vec3 q = womans(p), root(0.0660f, 1.590f, 0);
    return glm::vec3(root.x + (q.x - root.x) * 0.66f, root.y + (q.y - root.y) * 0.80f, q.z);
}

void shape(Mesh &mesh)
{
    std::vector<uint8_t> ear(mesh.points.size(), 0);
    for (const Face &face : mesh.faces)
        for (const Corner &corner : face.corners) ear[corner.point] = face.chart != Chart::head;
    for (size_t i = 0; i < mesh.points.size(); ++i) {
        Point &point = mesh.points[i];
        const Side side = point.position.x >= 0 ? Side::left : Side::right;
        const glm::vec3 p = mirrored(point.position, side);
        glm::vec3 to = ear[i] ? small_ear(p) : dressed(womans(p));
        for (const Moved &moved : throat)
            if (p == moved.from) to = moved.to;
        for (size_t k = 0; k < neckline.size(); ++k)
            if (p == neckline[k]) to = bodice_neckline[k];
        point.position = mirrored(to, side);
    }
}

// More area of the chart for the face, less for hair and neck.
glm::vec2 spread(glm::vec2 st)
{
    static const glm::vec2 across[] = {{0, 0}, {0.24f, 0.30f}, {0.34f, 0.40f}, {0.50f, 0.50f}};
    static const glm::vec2 up[] = {{1.44f, 1.370f},  {1.50f, 1.455f}, {1.535f, 1.490f},
                                   {1.665f, 1.680f}, {1.74f, 1.790f}, {1.90f, 1.900f}};
    return glm::vec2(st.x < 0 ? -profile(across, -st.x) : profile(across, st.x), profile(up, st.y));
}

void add_bun(Mesh &mesh)
{
    const glm::vec3 centre(0, 1.712f, -0.078f), back(0, 0.40f, -0.917f), up(0, 0.917f, 0.40f);
    struct Ring {
        float out, radius, st;
    };
    Chain before;
    for (const Ring r : {Ring{-0.024f, 0.054f, 1.0f}, Ring{0.042f, 0.055f, 0.72f}, Ring{0.066f, 0.032f, 0.36f}}) {
        Chain next;
        const std::vector<uint32_t> ring = add_ring(mesh, Region::head, Side::left, 7, centre + back * r.out,
                                                    {-1, 0, 0}, up, {r.radius, r.radius, r.radius, r.radius});
        for (size_t i = 0; i <= ring.size(); ++i) {
            const float angle = 6.28318531f * static_cast<float>(i) / static_cast<float>(ring.size());
            next.push_back({ring[i % ring.size()], r.st * glm::vec2(-math::sin(angle), -math::cos(angle))});
        }
        for (size_t i = 0; i + 1 < before.size(); ++i)
            mesh.sew(bun, Winding::reversed, {before[i], before[i + 1]}, {next[i], next[i + 1]}, Along::s);
        before = next;
    }
    before.pop_back();
    mesh.cap(bun, Winding::reversed, before);
}

void add_earring(Mesh &mesh, Side side)
{
    const glm::vec3 lobe(0.0790f, 1.590f, 0.000f);
    const auto at = [&](glm::vec3 d) { return mesh.add(mirrored(lobe + d, side), Region::head, side); };
    const uint32_t top = at({0, 0.004f, 0}), bottom = at({0.002f, -0.036f, 0});
    const std::array<uint32_t, 3> ring = {at({0.0075f, -0.022f, 0}), at({-0.005f, -0.022f, 0.007f}),
                                          at({-0.005f, -0.022f, -0.007f})};
    const Chart chart = on(side, earring);
    for (size_t i = 0; i < 3; ++i) {
        const float s = static_cast<float>(i);
        const Corner a = {ring[i], {s, 0}}, b = {ring[(i + 1) % 3], {s + 1, 0}};
        const Winding turned = side == Side::left ? Winding::reversed : Winding::as_given;
        mesh.face(chart, turned, a, b, {top, {s + 0.5f, 1}});
        mesh.face(chart, winding_of(side), a, b, {bottom, {s + 0.5f, -1}});
    }
}

}  // namespace

void add_lady_head(Mesh &mesh)
{
    add_head(mesh);
    shape(mesh);
    for (Face &face : mesh.faces)
        if (face.chart == Chart::head)
            for (Corner &corner : face.corners) corner.st = spread(corner.st);
    add_bun(mesh);
    add_earring(mesh, Side::left);
    add_earring(mesh, Side::right);
}

}  // namespace claque::figures::patrician
