// How materials act with light and alpha: emission, BLEND, and the looks that GL 1.1 lacks.
#include <algorithm>
#include <map>

#include "lib/asset/decoders.h"
#include "lib/asset/gltf_image.h"
#include "lib/asset/gltf_material.h"
#include "lib/asset/near_colours.h"
#include "lib/asset/zone_ranges.h"

namespace claque::asset
{

using model::AlphaMode;
using model::Material;

namespace
{

std::string list_of(const std::vector<std::string> &names)
{
    std::string list;
    for (const std::string &name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

}  // namespace

// Whether the library reads the picture of a texture.
bool Materials::has_picture(const JsonView &info) const
{
    const JsonView textures = file_.root["textures"];
    const JsonView texture = textures.at(info["index"].index(textures.count(), "texture"));
    const bool is_webp = texture["extensions"]["EXT_texture_webp"].exists();
    return texture["source"].exists() || (is_webp && has_decoder(Decoder::webp));
}

// Emission on black does not depend on light, and is the colour and the texture of a material without lighting. So is
// a picture of emission on nearly black: screens have that. On other colours GL adds emission to the light, before the
// texture multiplies both.
void Materials::read_emission(const Light &light, Material &out, UvUse &use)
{
    if (light.texture.exists() && !has_picture(light.texture)) {
        file_.warn(base::text_of("material '%s' emits by a picture that is not read: shown without its emission",
                                 out.name.c_str()));
        return;
    }
    const uint32_t index = static_cast<uint32_t>(materials_.size());
    constexpr float nearly_black = 0.1f;
    const float base = *std::max_element(out.base_colour.begin(), out.base_colour.begin() + 3);
    const bool is_black = base <= (light.texture.exists() ? nearly_black : 0.0f);
    if (is_black && (out.image == none || out.alpha_mode == AlphaMode::opaque)) {
        out.lighting.unlit = true;
        std::copy(light.emission.begin(), light.emission.end(), out.base_colour.begin());
        out.image = none, use = UvUse();
        glowing_.insert(index);
        if (light.texture.exists()) read_texture(light.texture, out, use);
        return;
    }
    Material shown;
    UvUse mapping;
    if (light.texture.exists()) read_texture(light.texture, shown, mapping);
    const bool same = shown.image == out.image && mapping.set == use.set && shown.wrap_s == out.wrap_s &&
                      shown.wrap_t == out.wrap_t &&
                      std::equal(use.transform.m, use.transform.m + 6, mapping.transform.m);
    if (shown.image != none && !same) {
        emission_pictures_[index] = {light.emission, shown.image};
        return;
    }
    out.lighting.emission = light.emission;
    if (out.image != none && shown.image == none)
        file_.warn(
            base::text_of("material '%s' emits one colour over a picture, and the picture darkens its emission; "
                          "KHR_materials_unlit, or a base colour without a picture, shows it in full",
                          out.name.c_str()));
}

// A picture of one colour is a factor; any other would have to be added to what light makes of the base colour.
void Materials::add_emission_of_pictures(const std::vector<bool> &used, const model::Model &model)
{
    for (const auto &[index, picture] : emission_pictures_) {
        if (!used[index]) continue;
        const auto known = decoded_.find(picture.image);
        const bool is_kept = known != decoded_.end() && known->second != none;
        std::optional<model::Image> image;
        if (is_kept) image = model.images[known->second];
        else image = read_image(file_, picture.image);
        std::array<float, 3> colour = {0, 0, 0};
        if (!image) continue;
        if (!has_one_colour(*image, colour)) {
            file_.warn(
                base::text_of("material '%s' emits by a picture over a lit colour, which GL 1.1 cannot add: shown "
                              "without its emission; a black base colour, or KHR_materials_unlit, shows it",
                              materials_[index].name.c_str()));
            continue;
        }
        for (size_t k = 0; k < 3; ++k) materials_[index].lighting.emission[k] = picture.factor[k] * colour[k];
    }
}

// Many files say MASK or BLEND where nothing is cut out or transparent. Returns how a material of BLEND that is
// transparent is shown, and the remedy.
std::string Materials::settle_alpha(uint32_t index, const model::Model &model)
{
    const bool is_blended = blended_.count(index) != 0;
    if (!is_blended && variants_.count() > 0) return "";  // whose pictures may have holes
    Material &material = materials_[index];
    AlphaExtent alpha;
    if (material.image != none) {
        const model::Image &image = model.images[material.image];
        if (image.alpha == model::AlphaMeaning::opacity) alpha = alpha_extent_of(image);
    }
    const float least = alpha.least * material.base_colour[3], most = alpha.most * material.base_colour[3];
    const bool is_whole = least >= material.alpha_cutoff;
    if (is_whole || (is_blended && file_.options.blend == Blend::opaque)) material.alpha_mode = AlphaMode::opaque;
    constexpr float opaque = 0.9f, empty = 0.05f;
    if (!is_blended || least >= opaque || file_.options.blend != Blend::unset) return "";
    if (is_whole) return "drawn as opaque";
    const bool is_unseen = most < material.alpha_cutoff;
    const char *shown = is_unseen ? "left out, as alpha is below 0.5 everywhere"
                                  : "drawn where alpha is 0.5 and more, and there opaque";
    const ZoneKind kind = zone_kind_of(material.name);
    // Opaque, empty texels are black boxes, and cards of hair and lashes are bars.
    const bool has_cut_outs = kind == ZoneKind::hair || kind == ZoneKind::eyes || (least < empty && !is_unseen);
    return std::string(shown) + (has_cut_outs ? "" : "; --blend opaque (clq_asset_options.blend) shows all of it");
}

void Materials::name_unseen_looks(const std::vector<bool> &used)
{
    std::vector<std::string> names;
    for (size_t i = 0; i < views_.size(); ++i)
        if (used[i]) note_unseen_looks(views_[i], names);
    if (names.empty()) return;
    file_.warn(base::text_of("materials are shown without %.400s: fixed-function lighting has none of them",
                             list_of(names).c_str()));
}

void Materials::settle_light(const std::vector<bool> &used, model::Model &model)
{
    add_emission_of_pictures(used, model);
    std::map<std::string, std::vector<std::string>> shown;  // names by how they are shown
    for (uint32_t material = 0; material < materials_.size(); ++material) {
        if (!used[material] || materials_[material].alpha_mode != AlphaMode::mask) continue;
        const std::string how = settle_alpha(material, model);
        if (!how.empty()) shown[how].push_back("'" + materials_[material].name + "'");
    }
    for (const auto &[how, names] : shown)
        file_.warn(base::text_of("%s %.400s %s transparent: %s", names.size() == 1 ? "material" : "materials",
                                 list_of(names).c_str(), names.size() == 1 ? "is" : "are", how.c_str()));
    name_unseen_looks(used);
}

// A zone that glows keeps its colour: dyes are for cloth.
void Materials::keep_glow(const std::vector<bool> &used, model::Model &model) const
{
    for (const uint32_t material : glowing_)
        if (used[material] && model.materials[material].zone != none)
            keep_colour(model.zones[model.materials[material].zone]);
}

}  // namespace claque::asset
