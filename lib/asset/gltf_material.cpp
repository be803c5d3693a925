#include "lib/asset/gltf_material.h"

#include <algorithm>
#include <cmath>

#include "lib/asset/decoders.h"
#include "lib/asset/gltf_image.h"
#include "lib/asset/material_zones.h"
#include "lib/asset/srgb.h"
#include "lib/asset/zone_extras.h"
#include "lib/math/trig.h"

namespace claque::asset
{

using base::fail;
using model::Material;

namespace
{

model::Wrap wrap_of(const JsonView &view)
{
    switch (view.integer_or(10497, 0, 0xffff)) {
        case 10497:
            return model::Wrap::repeat;
        case 33071:
            return model::Wrap::clamp;
        case 33648:
            return model::Wrap::mirror;
        default:
            break;
    }
    fail(CLQ_FORMAT, "%s is none of 10497, 33071 and 33648", view.path().c_str());
}

UvTransform transform_of(const JsonView &view)
{
    UvTransform out;
    if (!view.exists()) return out;
    float offset[2] = {0, 0}, scale[2] = {1, 1};
    if (view["offset"].exists()) view["offset"].numbers(offset, 2);
    if (view["scale"].exists()) view["scale"].numbers(scale, 2);
    const float angle = view["rotation"].real_or(0), c = math::cos(angle), s = math::sin(angle);
    // v points down, so a counter-clockwise rotation on the screen has these signs.
    const float m[6] = {scale[0] * c, -scale[0] * s, scale[1] * s, scale[1] * c, offset[0], offset[1]};
    for (int k = 0; k < 6; ++k) out.m[k] = m[k];
    return out;
}

// Sections that are not read must still have the right JSON type.
void check_objects(const JsonView &list)
{
    for (size_t i = 0; i < list.count(); ++i) list.at(i).object();
}

void check_textures(const File &file)
{
    const JsonView textures = file.root["textures"];
    check_objects(file.root["samplers"]);
    for (size_t i = 0; i < textures.count(); ++i) {
        textures.at(i)["source"].index_or_none(file.root["images"].count(), "image");
        textures.at(i)["sampler"].index_or_none(file.root["samplers"].count(), "sampler");
    }
    const JsonView images = file.root["images"];
    for (size_t i = 0; i < images.count(); ++i)
        images.at(i)["bufferView"].index_or_none(file.buffers.view_count(), "buffer view");
}

}  // namespace

Materials::Materials(File &file) : file_(file), variants_(file)
{
    check_textures(file);
    const JsonView list = file.root["materials"];
    for (size_t i = 0; i < list.count(); ++i) read(list.at(i));
}

void Materials::read(const JsonView &view)
{
    Material out;
    UvUse use;
    view.object();
    out.name = view["name"].text_or("");
    if (out.name.empty()) out.name = "material " + std::to_string(materials_.size());
    out.double_sided = view["doubleSided"].boolean_or(false);
    // Older files have only this extension.
    const JsonView glossy = view["extensions"]["KHR_materials_pbrSpecularGlossiness"];
    const bool is_glossy = glossy.exists() && !view["pbrMetallicRoughness"].exists();
    const JsonView look = is_glossy ? glossy : view["pbrMetallicRoughness"];
    const JsonView factor = look[is_glossy ? "diffuseFactor" : "baseColorFactor"];
    if (factor.exists()) factor.numbers(out.base_colour.data(), 4);
    for (size_t k = 0; k < 3; ++k) out.base_colour[k] = encoded(out.base_colour[k]);
    out.base_colour[3] = std::fmin(std::fmax(out.base_colour[3], 0.0f), 1.0f);
    const JsonView texture = look[is_glossy ? "diffuseTexture" : "baseColorTexture"];
    if (texture.exists()) read_texture(texture, out, use);
    read_alpha(view, out);
    const Light light = read_light(view);
    out.lighting.unlit = light.unlit;
    if (light.emits()) read_emission(light, out, use);
    materials_.push_back(out);
    uv_uses_.push_back(use);
    views_.push_back(view);
}

void Materials::read_texture(const JsonView &info, Material &out, UvUse &use)
{
    const JsonView texture = file_.root["textures"].at(info["index"].index(file_.root["textures"].count(), "texture"));
    out.image = image_source(texture);
    if (out.image == none) return;
    const uint32_t sampler = texture["sampler"].index_or_none(file_.root["samplers"].count(), "sampler");
    if (sampler != none) {
        out.wrap_s = wrap_of(file_.root["samplers"].at(sampler)["wrapS"]);
        out.wrap_t = wrap_of(file_.root["samplers"].at(sampler)["wrapT"]);
    }
    const JsonView transform = info["extensions"]["KHR_texture_transform"];
    use.has_texture = true;
    use.set = static_cast<uint32_t>(info["texCoord"].integer_or(0, 0, 1000));
    use.set = static_cast<uint32_t>(transform["texCoord"].integer_or(use.set, 0, 1000));
    use.transform = transform_of(transform);
}

uint32_t Materials::image_source(const JsonView &texture)
{
    const uint32_t source = texture["source"].index_or_none(file_.root["images"].count(), "image");
    if (source != none) return source;
    const JsonView extensions = texture["extensions"];
    const JsonView webp = extensions["EXT_texture_webp"];
    if (webp.exists() && !has_decoder(Decoder::webp)) refuse_without(Decoder::webp, texture.path());
    if (webp.exists()) return webp["source"].index(file_.root["images"].count(), "image");
    for (const char *name : {"KHR_texture_basisu", "MSFT_texture_dds", "EXT_texture_avif"})
        if (extensions[name].exists())
            fail(CLQ_UNSUPPORTED, "%s has an image by %s only, and no PNG or JPEG beside it", texture.path().c_str(),
                 name);
    file_.warn(base::text_of("%s has no image: shown without", texture.path().c_str()));
    return none;
}

void Materials::read_alpha(const JsonView &view, Material &out)
{
    const std::string mode = view["alphaMode"].text_or("OPAQUE");
    out.alpha_cutoff = view["alphaCutoff"].real_or(0.5f);
    if (mode == "MASK" || mode == "BLEND") out.alpha_mode = model::AlphaMode::mask;
    if (mode == "BLEND") out.alpha_cutoff = 0.5f, blended_.insert(static_cast<uint32_t>(materials_.size()));
    if (mode != "OPAQUE" && mode != "MASK" && mode != "BLEND")
        file_.warn(
            base::text_of("material '%s' has the alpha mode '%.40s': drawn opaque", out.name.c_str(), mode.c_str()));
}

uint32_t Materials::reference(const JsonView &view)
{
    if (view.exists()) return view.index(views_.size(), "material");
    if (default_ == none) {
        default_ = static_cast<uint32_t>(materials_.size());
        materials_.emplace_back();
        materials_.back().name = "default";
        uv_uses_.emplace_back();
    }
    return default_;
}

uint32_t Materials::without_texture(uint32_t material)
{
    const auto [place, is_new] = untextured_.emplace(material, static_cast<uint32_t>(materials_.size()));
    if (is_new) {
        Material bare = materials_[material];
        bare.image = none;
        if (blended_.count(material)) blended_.insert(place->second);
        if (glowing_.count(material)) glowing_.insert(place->second);
        materials_.push_back(bare);
        uv_uses_.emplace_back();
    }
    return place->second;
}

namespace
{

std::string image_key(const JsonView &view)
{
    if (view["bufferView"].exists()) return std::to_string(view["bufferView"].integer(0, 0xffffffffu));
    return "uri " + view["uri"].text();
}

}  // namespace

uint32_t Materials::decoded(uint32_t source, model::Model &model)
{
    const auto [place, is_new] = decoded_.emplace(source, none);
    if (!is_new) return place->second;
    // Images that read the same bytes are one, unless extras could tell them apart.
    const JsonView view = file_.root["images"].at(source);
    const bool may_share = !view["extras"].exists();
    const std::string key = may_share ? image_key(view) : std::string();
    if (may_share)
        if (const auto known = images_.find(key); known != images_.end()) return place->second = known->second;
    std::optional<model::Image> image = read_image(file_, source);
    if (image) {
        place->second = static_cast<uint32_t>(model.images.size());
        model.images.push_back(std::move(*image));
        sources_.push_back(source);
    }
    if (may_share) images_.emplace(key, place->second);
    return place->second;
}

void Materials::decode_images(const std::vector<bool> &used, model::Model &model)
{
    for (size_t i = 0; i < materials_.size(); ++i) {
        uint32_t &image = materials_[i].image;
        file_images_.push_back(image);
        if (image != none) image = used[i] ? decoded(image, model) : none;
    }
}

void Materials::add_keys(model::Image &image, const JsonView &extras, model::Model &model)
{
    const std::vector<model::Zone> zones = read_zone_extras(extras);
    if (zones.empty()) return;
    image.alpha = model::AlphaMeaning::zone_keys;
    add_keyed_zones(model.zones, zones, extras.path());
}

void Materials::mark_keyed(const std::vector<bool> &used, model::Model &model)
{
    for (size_t k = 0; k < sources_.size(); ++k)
        add_keys(model.images[k], file_.root["images"].at(sources_[k])["extras"], model);
    for (size_t i = 0; i < views_.size(); ++i)
        if (used[i] && materials_[i].image != none)
            add_keys(model.images[materials_[i].image], views_[i]["extras"], model);
}

// The image that a variant shows in place of a material's own; none if it cannot.
uint32_t Materials::image_of_variant(uint32_t material, uint32_t other, const std::string &variant, model::Model &model)
{
    const Material &own = materials_[material], &shown = materials_[other];
    const auto refuse = [&](const char *why) {
        file_.warn(base::text_of("variant '%s' cannot show material '%s' for '%s', %s: it shows the latter",
                                 variant.c_str(), shown.name.c_str(), own.name.c_str(), why));
        return none;
    };
    const UvUse &use = uv_uses_[material], &others = uv_uses_[other];
    if (own.image == none || file_images_[other] == none) return refuse("since both need a texture for that");
    if (!std::equal(use.transform.m, use.transform.m + 6, others.transform.m) || use.set != others.set)
        return refuse("whose texture has another mapping");
    const size_t known = sources_.size();
    const uint32_t image = decoded(file_images_[other], model);
    if (image == none) return refuse("whose picture is missing");
    if (sources_.size() != known)
        add_keys(model.images[image], file_.root["images"].at(sources_[image])["extras"], model);
    if (model.images[image].alpha != model.images[own.image].alpha)
        add_keys(model.images[image], views_[other]["extras"], model);
    if (model.images[image].alpha != model.images[own.image].alpha)
        return refuse("since only one of them has zone keys in its texture");
    if (own.base_colour != shown.base_colour || own.wrap_s != shown.wrap_s || own.wrap_t != shown.wrap_t ||
        own.double_sided != shown.double_sided || own.alpha_mode != shown.alpha_mode || own.lighting != shown.lighting)
        file_.warn(
            base::text_of("variant '%s': only the texture of material '%s' is used, everything else is from '%s'",
                          variant.c_str(), shown.name.c_str(), own.name.c_str()));
    return image == own.image ? none : image;
}

void Materials::add_texture_sets(const std::vector<bool> &used, model::Model &model)
{
    for (size_t v = 0; v < variants_.count() && v + 1 < model::max_texture_sets; ++v) {
        model::TextureSet set;
        set.name = variants_.name(v);
        set.images.assign(materials_.size(), none);
        for (const auto &[material, other] : variants_.mapped(v))
            if (used[material] && other != material)
                set.images[material] = image_of_variant(material, other, set.name, model);
        model.texture_sets.push_back(std::move(set));
    }
}

void Materials::finish(const std::vector<bool> &used, model::Model &model)
{
    decode_images(used, model);
    mark_keyed(used, model);
    settle_light(used, model);
    add_texture_sets(used, model);
    model.materials = std::move(materials_);
    add_material_zones(used, model);
    keep_glow(used, model);
}

}  // namespace claque::asset
