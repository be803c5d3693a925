// Textures with zone keys have one mip level, sampled GL_NEAREST: GL 1.1 cannot limit a mip chain, and mixed keys would
// be other keys (S2 2.4). Triangles that may be filtered use a second texture.
#include <algorithm>

#include "passes/guard.h"
#include "passes/prepared.h"

namespace claque::passes
{
namespace
{

int32_t wrap_of(model::Wrap wrap) { return static_cast<int32_t>(wrap == model::Wrap::clamp ? gl::clamp : gl::repeat); }

// `image` is the texture itself, or its image in another set.
// False: GL did not take it.
template <class Image>
bool upload(const Gl11 &gl, const model::Texture &texture, const Image &image, uint32_t name, uint32_t filter)
{
    gl.BindTexture(gl::texture_2d, name);
    gl.TexParameteri(gl::texture_2d, gl::texture_min_filter, static_cast<int32_t>(filter));
    gl.TexParameteri(gl::texture_2d, gl::texture_mag_filter, static_cast<int32_t>(filter));
    gl.TexParameteri(gl::texture_2d, gl::wrap_s, wrap_of(texture.wrap_s));
    gl.TexParameteri(gl::texture_2d, gl::wrap_t, wrap_of(texture.wrap_t));
    gl.TexImage2D(gl::texture_2d, 0, static_cast<int32_t>(gl::rgba8), static_cast<int32_t>(image.width),
                  static_cast<int32_t>(image.height), 0, gl::rgba, gl::unsigned_byte, image.rgba.data());
    int32_t taken = 0;  // without memory GL keeps the texture as it was: without an image
    gl.GetTexLevelParameteriv(gl::texture_2d, 0, gl::texture_width, &taken);
    return taken == static_cast<int32_t>(image.width);
}

base::Status probe(const Gl11 &gl, const char *tmpl, int32_t width, int32_t height, int32_t maximum, int &alpha_bits)
{
    if (std::max(width, height) > maximum)
        return base::Status::bad(CLQ_LIMIT, "template '%s': a texture of %d x %d pixels, this GL takes %d at most",
                                 tmpl, width, height, maximum);
    gl.TexImage2D(gl::proxy_texture_2d, 0, static_cast<int32_t>(gl::rgba8), width, height, 0, gl::rgba,
                  gl::unsigned_byte, nullptr);
    int32_t taken = 0, bits = 0;
    gl.GetTexLevelParameteriv(gl::proxy_texture_2d, 0, gl::texture_width, &taken);
    gl.GetTexLevelParameteriv(gl::proxy_texture_2d, 0, gl::texture_alpha_size, &bits);
    if (taken != width)
        return base::Status::bad(CLQ_LIMIT, "template '%s': this GL does not take a texture of %d x %d pixels", tmpl,
                                 width, height);
    alpha_bits = std::min(alpha_bits, static_cast<int>(bits));
    return base::Status::good();
}

}  // namespace

base::Status probe_textures(const Gl11 &gl, const model::Template &source, int &alpha_bits)
{
    int32_t maximum = 0;
    gl.GetIntegerv(gl::max_texture_size, &maximum);
    alpha_bits = 8;
    base::Status status = base::Status::good();
    const auto probe_image = [&](uint32_t width, uint32_t height) {
        if (status.ok())
            status = probe(gl, source.name.c_str(), static_cast<int32_t>(width), static_cast<int32_t>(height), maximum,
                           alpha_bits);
    };
    for (const model::Texture &texture : source.textures) {
        probe_image(texture.width, texture.height);
        for (const model::TextureImage &other : texture.set_images) probe_image(other.width, other.height);
    }
    return status;
}

base::Status upload_textures(const Gl11 &gl, PreparedTemplate &prepared)
{
    const UploadGuard guard(gl);
    bool taken = true;
    for (size_t i = 0; i < prepared.textures.size(); ++i) {
        const model::Texture &texture = prepared.source->textures[i];
        const auto bring = [&](Array<uint32_t> &names, uint32_t filter) {
            if (names.empty()) return;
            gl.GenTextures(static_cast<int32_t>(names.size()), names.data());
            taken = upload(gl, texture, texture, names[0], filter) && taken;
            for (size_t k = 1; k < names.size(); ++k)
                taken = upload(gl, texture, texture.set_images[k - 1], names[k], filter) && taken;
        };
        bring(prepared.textures[i].names, gl::nearest);
        bring(prepared.textures[i].linear_names, gl::linear);
    }
    if (taken) return base::Status::good();
    delete_textures(gl, prepared);
    return base::Status::bad(CLQ_OUT_OF_MEMORY, "template '%s': GL has no memory for its textures",
                             prepared.source->name.c_str());
}

void delete_textures(const Gl11 &gl, PreparedTemplate &prepared)
{
    for (PreparedTexture &texture : prepared.textures)
        for (const Array<uint32_t> *names : {&texture.names, &texture.linear_names})
            if (!names->empty()) gl.DeleteTextures(static_cast<int32_t>(names->size()), names->data());
}

}  // namespace claque::passes
