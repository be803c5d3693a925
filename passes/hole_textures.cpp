#include "passes/hole_textures.h"

#include <new>

#include "passes/guard.h"

namespace claque::passes
{
namespace
{

int32_t wrapping_of(model::Wrap wrap)
{
    return static_cast<int32_t>(wrap == model::Wrap::clamp ? gl::clamp : gl::repeat);
}

// Sets that show the same image share a texture.
uint32_t image_of(const model::Texture &texture, uint32_t set) { return texture.set_images.empty() ? 0 : set; }

}  // namespace

uint32_t HoleTextures::find(const model::Template &tmpl, uint32_t texture, uint32_t set) const
{
    const uint32_t image = image_of(tmpl.textures[texture], set);
    for (const One &one : textures_)
        if (one.tmpl == &tmpl && one.texture == texture && one.set == image) return one.name;
    return 0;
}

bool HoleTextures::load(const Gl11 &gl, const model::Template &tmpl, uint32_t texture, uint32_t set)
{
    const model::Texture &from = tmpl.textures[texture];
    const model::Array<uint8_t> &rgba = set == 0 ? from.rgba : from.set_images[set - 1].rgba;
    const uint32_t width = set == 0 ? from.width : from.set_images[set - 1].width;
    const uint32_t height = set == 0 ? from.height : from.set_images[set - 1].height;
    texels_.resize(rgba.size() / 4);
    for (size_t i = 0; i < texels_.size(); ++i) texels_[i] = rgba[4 * i + 3] == 0 ? 0 : 255;
    textures_.push_back({&tmpl, texture, set, 0});
    uint32_t &name = textures_.back().name;
    gl.GenTextures(1, &name);
    gl.BindTexture(gl::texture_2d, name);
    gl.TexParameteri(gl::texture_2d, gl::texture_min_filter, static_cast<int32_t>(gl::nearest));
    gl.TexParameteri(gl::texture_2d, gl::texture_mag_filter, static_cast<int32_t>(gl::nearest));
    gl.TexParameteri(gl::texture_2d, gl::wrap_s, wrapping_of(from.wrap_s));
    gl.TexParameteri(gl::texture_2d, gl::wrap_t, wrapping_of(from.wrap_t));
    gl.TexImage2D(gl::texture_2d, 0, static_cast<int32_t>(gl::alpha8), static_cast<int32_t>(width),
                  static_cast<int32_t>(height), 0, gl::alpha, gl::unsigned_byte, texels_.data());
    int32_t taken = 0;
    gl.GetTexLevelParameteriv(gl::texture_2d, 0, gl::texture_width, &taken);
    if (taken == static_cast<int32_t>(width)) return true;
    gl.DeleteTextures(1, &name);
    textures_.pop_back();
    return false;
}

base::Status HoleTextures::prepare(const Gl11 &gl, const Preflight &preflight, const draw::DrawList &list)
try {
    const draw::Item *before = nullptr;
    for (const draw::Item &item : list.items) {
        if (item.shadow_only) continue;
        if (before && before->tmpl == item.tmpl && before->texture_set == item.texture_set) continue;
        before = &item;
        for (uint32_t texture = 0; texture < item.tmpl->textures.size(); ++texture) {
            const model::Texture &from = item.tmpl->textures[texture];
            if (!from.has_holes || find(*item.tmpl, texture, item.texture_set) != 0) continue;
            if (base::Status status = preflight.check_upload(gl); !status.ok()) return status;
            const UploadGuard guard(gl);
            if (!load(gl, *item.tmpl, texture, image_of(from, item.texture_set)))
                return base::Status::bad(CLQ_OUT_OF_MEMORY,
                                         "template '%s': GL has no memory for the holes of texture %u",
                                         item.tmpl->name.c_str(), texture);
        }
    }
    return base::Status::good();
} catch (const std::bad_alloc &) {
    return base::Status::bad(CLQ_OUT_OF_MEMORY, "no memory for the holes of textures");
}

void HoleTextures::destroy(const Gl11 &gl)
{
    for (const One &one : textures_) gl.DeleteTextures(1, &one.name);
    abandon();
}

}  // namespace claque::passes
