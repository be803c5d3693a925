// Key textures have one level, sampled GL_NEAREST: GL 1.1 cannot limit a mip chain, and mixing keys would make new ones
// (S2 2.4).
#include "passes/guard.h"
#include "passes/prepared.h"

#include <algorithm>

namespace claque::passes
{
namespace
{

int32_t wrap_of(model::Wrap wrap) { return static_cast<int32_t>(wrap == model::Wrap::clamp ? gl::clamp : gl::repeat); }

void upload(const Gl11 &gl, const model::Texture &texture, uint32_t name)
{
    gl.BindTexture(gl::texture_2d, name);
    gl.TexParameteri(gl::texture_2d, gl::texture_min_filter, static_cast<int32_t>(gl::nearest));
    gl.TexParameteri(gl::texture_2d, gl::texture_mag_filter, static_cast<int32_t>(gl::nearest));
    gl.TexParameteri(gl::texture_2d, gl::wrap_s, wrap_of(texture.wrap_s));
    gl.TexParameteri(gl::texture_2d, gl::wrap_t, wrap_of(texture.wrap_t));
    gl.TexImage2D(gl::texture_2d, 0, static_cast<int32_t>(gl::rgba8), static_cast<int32_t>(texture.width),
                  static_cast<int32_t>(texture.height), 0, gl::rgba, gl::unsigned_byte, texture.rgba.data());
}

}  // namespace

base::Status probe_textures(const Gl11 &gl, const model::Template &source, int &alpha_bits)
{
    int32_t most = 0;
    gl.GetIntegerv(gl::max_texture_size, &most);
    alpha_bits = 8;
    for (const model::Texture &texture : source.textures) {
        const int32_t width = static_cast<int32_t>(texture.width), height = static_cast<int32_t>(texture.height);
        if (std::max(width, height) > most)
            return base::Status::bad(CLQ_LIMIT, "template '%s': a texture of %d x %d pixels, this GL takes %d at most",
                                     source.name.c_str(), width, height, most);
        gl.TexImage2D(gl::proxy_texture_2d, 0, static_cast<int32_t>(gl::rgba8), width, height, 0, gl::rgba,
                      gl::unsigned_byte, nullptr);
        int32_t taken = 0, bits = 0;
        gl.GetTexLevelParameteriv(gl::proxy_texture_2d, 0, gl::texture_width, &taken);
        gl.GetTexLevelParameteriv(gl::proxy_texture_2d, 0, gl::texture_alpha_size, &bits);
        if (taken != width)
            return base::Status::bad(CLQ_LIMIT, "template '%s': this GL does not take a texture of %d x %d pixels",
                                     source.name.c_str(), width, height);
        alpha_bits = std::min(alpha_bits, static_cast<int>(bits));
    }
    return base::Status::good();
}

void upload_textures(const Gl11 &gl, PreparedTemplate &prepared)
{
    const UploadGuard guard(gl);
    for (size_t i = 0; i < prepared.textures.size(); ++i) {
        gl.GenTextures(1, &prepared.textures[i].name);
        upload(gl, prepared.source->textures[i], prepared.textures[i].name);
    }
}

void delete_textures(const Gl11 &gl, PreparedTemplate &prepared)
{
    for (PreparedTexture &texture : prepared.textures) gl.DeleteTextures(1, &texture.name);
}

}  // namespace claque::passes
