#include "samples/scenes/texture.h"

namespace scenes
{
namespace
{

// Each texel is the mean of four, rounded.
Image half(const Image &from)
{
    Image to;
    to.side_px = from.side_px / 2;
    to.rgba.resize(4 * static_cast<size_t>(to.side_px) * static_cast<size_t>(to.side_px));
    const size_t wide = static_cast<size_t>(from.side_px) * 4;
    for (int y = 0; y < to.side_px; ++y)
        for (int x = 0; x < to.side_px; ++x)
            for (size_t channel = 0; channel < 4; ++channel) {
                const size_t at = static_cast<size_t>(2 * y) * wide + static_cast<size_t>(2 * x) * 4 + channel;
                const int sum = from.rgba[at] + from.rgba[at + 4] + from.rgba[at + wide] + from.rgba[at + wide + 4];
                to.rgba[(static_cast<size_t>(y) * static_cast<size_t>(to.side_px) + static_cast<size_t>(x)) * 4 +
                        channel] = static_cast<uint8_t>((sum + 2) / 4);
            }
    return to;
}

}  // namespace

Texture::Texture(const Gl &g, const Image &image, bool repeats, Filter filter) : gl_(g)
{
    g.GenTextures(1, &id_);
    g.BindTexture(gl::texture_2d, id_);
    const bool smooth = filter != Filter::nearest;
    g.TexParameteri(gl::texture_2d, gl::mag_filter, smooth ? gl::linear : gl::nearest);
    g.TexParameteri(gl::texture_2d, gl::min_filter,
                    filter == Filter::trilinear  ? gl::linear_mipmap_linear
                    : filter == Filter::bilinear ? gl::linear_mipmap_nearest
                                                 : gl::nearest_mipmap_nearest);
    g.TexParameteri(gl::texture_2d, gl::wrap_s, repeats ? gl::repeat : gl::clamp);
    g.TexParameteri(gl::texture_2d, gl::wrap_t, repeats ? gl::repeat : gl::clamp);
    g.PixelStorei(gl::unpack_alignment, 1);
    Image level = image;
    for (int number = 0;; ++number) {
        g.TexImage2D(gl::texture_2d, number, gl::rgba, level.side_px, level.side_px, 0, gl::rgba, gl::unsigned_byte,
                     level.rgba.data());
        if (level.side_px == 1) break;
        level = half(level);
    }
}

Texture::~Texture() { gl_.DeleteTextures(1, &id_); }

void Texture::use() const
{
    gl_.Enable(gl::texture_2d);
    gl_.BindTexture(gl::texture_2d, id_);
    gl_.TexEnvi(gl::texture_env, gl::texture_env_mode, gl::modulate);
}

}  // namespace scenes
