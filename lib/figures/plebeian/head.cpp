// Makes a young man's head from the shared one: a narrow face with a clear jaw, a lean neck, and thick hair in tufts
// that falls over brow, temples and nape.
#include <cmath>

#include "lib/figures/brush.h"
#include "lib/figures/plebeian/plebeian.h"

namespace claque::figures::plebeian
{

namespace
{

glm::vec3 lean(glm::vec3 p)
{
    const float x = std::fabs(p.x);
    glm::vec3 q = p;
    const float ahead = smoothstep(-0.02f, 0.05f, p.z);
    q.x *= 0.965f - 0.055f * smoothstep(1.625f, 1.555f, p.y) * ahead;
    q.z -= 0.0040f * spot(glm::vec2(x, p.y), {0.052f, 1.578f}, {0.024f, 0.028f}) * ahead;           // lean cheeks
    q.z -= 0.0024f * spot(glm::vec2(x, p.y), {0.016f, 1.655f}, {0.040f, 0.018f});                   // a smooth brow
    q.z += 0.0030f * spot(glm::vec2(x, p.y), {0, 1.530f}, {0.026f, 0.016f}) * ahead;                // chin
    if (x < 0.013f) q.z -= 0.0022f * spot(p.y - 1.600f, 0.024f) * smoothstep(0.100f, 0.122f, p.z);  // a shorter nose
    const float neck = smoothstep(1.545f, 1.500f, p.y + 0.45f * p.z) * smoothstep(1.455f, 1.490f, p.y);
    q.x *= 1 - 0.07f * neck;
    return q;
}

// The thickness of the hair: thick on top and behind, in tufts.
float thickness(glm::vec3 p)
{
    static const glm::vec2 fringe[] = {
        {-0.1f, 1.545f}, {-0.03f, 1.580f}, {0.02f, 1.650f}, {0.06f, 1.690f}, {0.11f, 1.694f}};
    const float inside = smoothstep(-0.004f, 0.040f, p.y - profile(fringe, p.z));
    const float tuft = base::unit(base::mix(static_cast<uint64_t>(static_cast<int64_t>(p.x * 9000)) * 77 +
                                            static_cast<uint64_t>(static_cast<int64_t>(p.y * 9000)) * 3 +
                                            static_cast<uint64_t>(static_cast<int64_t>(p.z * 9000))));
    const float behind = 1 - 0.5f * smoothstep(-0.05f, -0.10f, p.z) * smoothstep(1.58f, 1.62f, p.y);
    return inside * behind * (0.006f + 0.022f * tuft);
}

glm::vec3 haired(glm::vec3 p, glm::vec3 q, Side side)
{
    // Left and right differ, as real hair does.
    const float out = thickness(side == Side::left ? p : p + glm::vec3(0.011f, 0.007f, 0.005f));
    const glm::vec3 from(0, 1.640f, -0.010f);
    const glm::vec3 d = q - from;
    return q + d / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z) * out;
}

// Points of the shared head under the chin and their positions here: a clear edge of the jaw and a long throat.
struct Moved {
    glm::vec3 from, to;
};
const std::array<Moved, 8> throat = {{
    {{0, 1.497f, 0.044f}, {0, 1.478f, 0.047f}},
    {{0.022f, 1.499f, 0.042f}, {0.022f, 1.480f, 0.042f}},
    {{0.040f, 1.502f, 0.030f}, {0.038f, 1.484f, 0.028f}},
    {{0, 1.517f, 0.082f}, {0, 1.516f, 0.058f}},
    {{0.019f, 1.519f, 0.079f}, {0.018f, 1.518f, 0.055f}},
    {{0.034f, 1.525f, 0.068f}, {0.032f, 1.525f, 0.050f}},
    {{0, 1.530f, 0.1025f}, {0, 1.5270f, 0.1025f}},
    {{0.019f, 1.532f, 0.0980f}, {0.018f, 1.5290f, 0.0970f}},
}};

glm::vec3 shaped(glm::vec3 p, Side side, bool ear)
{
    for (const glm::vec3 n : neckline)
        if (p == n) return p;
    for (const Moved &moved : throat)
        if (p == moved.from) return moved.to;
    glm::vec3 q = lean(p);
    if (!ear) return haired(p, q, side);
    q.z += 0.004f;  // out of the hair
    return q;
}

// More area of the chart for the face, less for hair and neck.
glm::vec2 spread(glm::vec2 st)
{
    static const glm::vec2 across[] = {{0, 0}, {0.24f, 0.28f}, {0.34f, 0.38f}, {0.50f, 0.50f}};
    static const glm::vec2 up[] = {{1.44f, 1.390f},  {1.50f, 1.462f}, {1.530f, 1.490f},
                                   {1.665f, 1.675f}, {1.74f, 1.770f}, {1.90f, 1.900f}};
    return glm::vec2(st.x < 0 ? -profile(across, -st.x) : profile(across, st.x), profile(up, st.y));
}

}  // namespace

void add_lean_head(Mesh &mesh)
{
    add_head(mesh);
    std::vector<uint8_t> ear(mesh.points.size(), 0);
    for (Face &face : mesh.faces)
        for (Corner &corner : face.corners)
            if (face.chart != Chart::head) ear[corner.point] = 1;
            else corner.st = spread(corner.st);
    for (size_t i = 0; i < mesh.points.size(); ++i) {
        glm::vec3 &position = mesh.points[i].position;
        const Side side = position.x >= 0 ? Side::left : Side::right;
        position = mirrored(shaped(mirrored(position, side), side, ear[i] != 0), side);
    }
}

}  // namespace claque::figures::plebeian
