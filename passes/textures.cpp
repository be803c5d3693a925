// Textures with zone keys have one mip level, sampled GL_NEAREST: GL 1.1 cannot limit a mip chain, and mixed keys would
// be other keys (S2 2.4). Triangles that may be filtered use a second texture.
#include <algorithm>

#include "passes/guard.h"
#include "passes/prepared.h"
#include "passes/smooth_levels.h"

namespace claque::passes
{
namespace
{

int32_t wrap_of(model::Wrap wrap) { return static_cast<int32_t>(wrap == model::Wrap::clamp ? gl::clamp : gl::repeat); }

// An image of a texture.
struct Pixels {
    uint32_t width, height;
    const uint8_t *rgba;
};

// Set 0 is the texture itself.
Pixels image_of(const model::Texture &texture, size_t set)
{
    if (set == 0) return {texture.width, texture.height, texture.rgba.data()};
    const model::TextureImage &other = texture.set_images[set - 1];
    return {other.width, other.height, other.rgba.data()};
}

// False: GL did not take it.
bool upload(const Gl11 &gl, const model::Texture &texture, const Pixels &image, uint32_t name, uint32_t filter)
{
    gl.BindTexture(gl::texture_2d, name);
    gl.TexParameteri(gl::texture_2d, gl::texture_min_filter, static_cast<int32_t>(filter));
    gl.TexParameteri(gl::texture_2d, gl::texture_mag_filter, static_cast<int32_t>(filter));
    gl.TexParameteri(gl::texture_2d, gl::wrap_s, wrap_of(texture.wrap_s));
    gl.TexParameteri(gl::texture_2d, gl::wrap_t, wrap_of(texture.wrap_t));
    gl.TexImage2D(gl::texture_2d, 0, static_cast<int32_t>(gl::rgba8), static_cast<int32_t>(image.width),
                  static_cast<int32_t>(image.height), 0, gl::rgba, gl::unsigned_byte, image.rgba);
    int32_t taken = 0;  // without memory GL keeps the texture as it was: without an image
    gl.GetTexLevelParameteriv(gl::texture_2d, 0, gl::texture_width, &taken);
    return taken == static_cast<int32_t>(image.width);
}

// The image of a set in each step of smoothing.
bool upload_smooth(const Gl11 &gl, const PreparedTemplate &prepared, uint32_t texture_index, size_t set)
{
    const model::Texture &texture = prepared.source->textures[texture_index];
    const PreparedTexture &ready = prepared.textures[texture_index];
    if (ready.smooth_steps == 0) return true;
    const Pixels image = image_of(texture, set);
    const std::vector<uint8_t> shown = shown_texels(*prepared.source, texture_index, image.width, image.height);
    std::vector<uint8_t> smooth(image.rgba, image.rgba + 4 * size_t(image.width) * image.height);
    bool taken = true;
    for (uint32_t step = 1; step <= ready.smooth_steps; ++step) {
        smooth = smooth_image(texture, smooth, image.width, image.height, shown, step);
        taken = upload(gl, texture, {image.width, image.height, smooth.data()}, ready.names[step * ready.sets() + set],
                       gl::nearest) &&
                taken;
    }
    return taken;
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
        PreparedTexture &ready = prepared.textures[i];
        const size_t sets = ready.sets();
        for (Array<uint32_t> *names : {&ready.names, &ready.linear_names})
            if (!names->empty()) gl.GenTextures(static_cast<int32_t>(names->size()), names->data());
        for (size_t set = 0; set < sets; ++set) {
            const Pixels image = image_of(texture, set);
            taken = upload(gl, texture, image, ready.names[set], gl::nearest) && taken;
            if (!ready.linear_names.empty())
                taken = upload(gl, texture, image, ready.linear_names[set], gl::linear) && taken;
            taken = upload_smooth(gl, prepared, uint32_t(i), set) && taken;
        }
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
