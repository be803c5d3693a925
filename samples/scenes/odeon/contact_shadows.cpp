#include "samples/scenes/odeon/contact_shadows.h"

#include <algorithm>
#include <cmath>

namespace scenes
{
namespace
{

constexpr float lift_m = 0.006f;
constexpr Rgb dark = {0.10f, 0.08f, 0.07f};

// Dark in the centre, fading to nothing at the rim.
Image blot()
{
    constexpr int side = 64;
    Image image;
    image.side_px = side;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double u = (x + 0.5) / side * 2 - 1, v = (y + 0.5) / side * 2 - 1;
            const double t = std::clamp(1.12 * (1 - std::sqrt(u * u + v * v)), 0.0, 1.0);
            const uint8_t alpha = static_cast<uint8_t>(255 * t * t * (3 - 2 * t) + 0.5);
            image.rgba.insert(image.rgba.end(), {255, 255, 255, alpha});
        }
    return image;
}

void lay(Geometry &patches, const Seat &seat, float scale)
{
    const double out = std::sqrt(seat.x * seat.x + seat.z * seat.z);
    const Vec3 back = {static_cast<float>(seat.x / out), 0, static_cast<float>(seat.z / out)};
    // A point to the right of a viewer who faces the seat, behind its edge, and up, in metres; u and v of the picture.
    const auto corner = [&](float aside, float behind, double y, Vec3 normal, float u, float v, float alpha) {
        return patches.add({static_cast<float>(seat.x) + back.x * behind - back.z * aside, static_cast<float>(y),
                            static_cast<float>(seat.z) + back.z * behind + back.x * aside},
                           normal, u, v, dark, alpha);
    };
    const auto flat = [&](float half, float front, float rear, double y, float v0, float v1, float alpha) {
        const Vec3 up = {0, 1, 0};
        const uint32_t a = corner(-half, front, y + lift_m, up, 0.01f, v0, alpha);
        const uint32_t b = corner(half, front, y + lift_m, up, 0.99f, v0, alpha);
        const uint32_t c = corner(half, rear, y + lift_m, up, 0.99f, v1, alpha);
        const uint32_t d = corner(-half, rear, y + lift_m, up, 0.01f, v1, alpha);
        patches.triangle(a, b, c);
        patches.triangle(a, c, d);
    };
    flat(0.46f * scale, 0.0f, 0.72f, seat.y, 0.16f, 0.99f, 0.80f);                         // under hips and thighs
    flat(0.42f * scale, -0.14f - 0.40f * scale, 0.06f, seat.step_y, 0.01f, 0.82f, 0.78f);  // under the feet
    const Vec3 inwards = {-back.x, 0, -back.z};
    const double top = seat.y - 0.13;
    const uint32_t a = corner(-0.42f * scale, 0.042f, seat.step_y, inwards, 0.01f, 0.5f, 0.62f);
    const uint32_t b = corner(0.42f * scale, 0.042f, seat.step_y, inwards, 0.99f, 0.5f, 0.62f);
    const uint32_t c = corner(0.42f * scale, 0.042f, top, inwards, 0.99f, 0.78f, 0.62f);
    const uint32_t d = corner(-0.42f * scale, 0.042f, top, inwards, 0.01f, 0.78f, 0.62f);
    patches.triangle(a, b, c);
    patches.triangle(a, c, d);
}

}  // namespace

ContactShadows::ContactShadows(const std::vector<Seat> &seats, const std::vector<Sitter> &sitters)
{
    Geometry patches;
    for (const Sitter &sitter : sitters) lay(patches, seats[sitter.seat], sitter.scale);
    patches_ = Blocks(patches, 3);
}

void ContactShadows::prepare(const Gl &gl) { image_.emplace(gl, blot(), false, Texture::Filter::bilinear); }

void ContactShadows::draw(const Gl &g, const Eye &eye, const Frustum *cull) const
{
    if (!image_) return;
    image_->use();
    g.Disable(gl::lighting);
    g.Disable(gl::cull_face);
    g.Enable(gl::blend);
    g.BlendFunc(gl::src_alpha, gl::one_minus_src_alpha);
    g.DepthMask(0);
    patches_.draw(g, eye, cull);
    g.DepthMask(1);
    g.Disable(gl::blend);
    g.Disable(gl::texture_2d);
    g.Enable(gl::lighting);
}

}  // namespace scenes
