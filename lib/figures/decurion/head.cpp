// Makes an old man's head from the shared one: jowls and a double chin, a heavy hooked nose, brows over deep sockets,
// long ears, a thick neck, and a scalp with little hair.
#include <cmath>

#include "lib/figures/brush.h"
#include "lib/figures/decurion/decurion.h"

namespace claque::figures::decurion
{

namespace
{

glm::vec3 aged(glm::vec3 p)
{
    const float x = std::fabs(p.x);
    const glm::vec2 front(x, p.y);
    const float ahead = smoothstep(-0.03f, 0.05f, p.z);
    glm::vec3 q = p;
    q.x *= 1.03f + 0.17f * ahead * smoothstep(1.612f, 1.550f, p.y);  // jowls
    q.y -= 0.006f * spot(front, {0.046f, 1.536f}, {0.030f, 0.026f}) * ahead;
    q.z += 0.006f * spot(front, {0.040f, 1.532f}, {0.034f, 0.030f}) * ahead;
    q.z += 0.004f * spot(front, {0.048f, 1.600f}, {0.026f, 0.020f});  // cheekbones
    q.z -= 0.003f * spot(front, {0.054f, 1.575f}, {0.016f, 0.020f});
    // Nose: high bridge, drooping tip, broad wings.
    if (x < 0.011f) {
        const float bridge = spot(front, {0, 1.620f}, {0.020f, 0.020f}),
                    tip = spot(front, {0, 1.595f}, {0.020f, 0.018f});
        q.z += 0.0085f * bridge + 0.0045f * tip;
        q.y -= 0.0065f * tip;
    }
    if (p.z > 0.098f && x > 0.008f && x < 0.020f && p.y > 1.58f && p.y < 1.605f) q.x *= 1.22f;
    q.z += 0.0055f * spot(front, {0.020f, 1.655f}, {0.036f, 0.016f});  // brows
    q.y -= 0.0030f * spot(front, {0.040f, 1.655f}, {0.026f, 0.014f});
    q.z -= 0.0050f * spot(front, {0.0310f, 1.6345f}, {0.018f, 0.013f}) * ahead;  // sockets
    q.z += 0.0020f * spot(front, {0.0310f, 1.6150f}, {0.020f, 0.012f}) * ahead;  // bags below them
    q.y -= 0.0016f * spot(front, {0.0265f, 1.5640f}, {0.014f, 0.012f}) * ahead;  // corners of the mouth
    q.z -= 0.0020f * spot(front, {0, 1.5640f}, {0.024f, 0.012f});
    q.z += 0.0050f * spot(front, {0, 1.5300f}, {0.030f, 0.016f}) * ahead;  // chin
    // Double chin and thick neck.
    const float throat = spot(glm::vec2(p.y, p.z), {1.506f, 0.056f}, {0.026f, 0.050f});
    q.y -= 0.014f * throat;
    q.z += 0.014f * throat;
    const float neck = smoothstep(1.565f, 1.510f, p.y + 0.35f * p.z);
    q.x *= 1 + 0.12f * neck;
    q.z = -0.015f + (q.z + 0.015f) * (1 + 0.10f * neck);
    // The scalp without a young man's hair is flatter on top; a wreath of hair remains at the sides and behind.
    const float scalp = smoothstep(1.685f, 1.740f, p.y);
    q.y -= 0.007f * scalp;
    q.z -= 0.006f * spot(front, {0, 1.715f}, {0.060f, 0.030f}) * ahead;
    const float wreath = spot(p.y - 1.650f, 0.060f) * smoothstep(0.030f, -0.020f, p.z);
    q.x *= 1 + 0.05f * wreath;
    q.z -= 0.004f * wreath * smoothstep(-0.03f, -0.08f, p.z);
    return q;
}

glm::vec3 long_ear(glm::vec3 p)
{
    const glm::vec3 root(0.0690f, 1.630f, 0);
    return glm::vec3(root.x + 0.002f + (p.x - root.x) * 1.18f, root.y + (p.y - root.y) * 1.18f, p.z * 1.05f);
}

}  // namespace

void add_aged_head(Mesh &mesh)
{
    add_head(mesh);
    std::vector<uint8_t> ear(mesh.points.size(), 0);
    for (const Face &face : mesh.faces)
        for (const Corner &corner : face.corners) ear[corner.point] = face.chart != Chart::head;
    for (size_t i = 0; i < mesh.points.size(); ++i) {
        Point &point = mesh.points[i];
        if (point.region != Region::head) continue;  // the neckline belongs to the tunic as well
        const Side side = point.position.x >= 0 ? Side::left : Side::right;
        const glm::vec3 p = mirrored(point.position, side);
        point.position = mirrored(ear[i] ? long_ear(p) : aged(p), side);
    }
}

}  // namespace claque::figures::decurion
