#include "lib/asset/gltf_variants.h"

namespace claque::asset
{

Variants::Variants(File &file) : file_(file)
{
    const JsonView list = file.root["extensions"]["KHR_materials_variants"]["variants"];
    for (size_t i = 0; i < list.count(); ++i) names_.push_back(list.at(i)["name"].text());
    if (names_.size() >= model::max_texture_sets) {
        file.warn(base::text_of("%s: %zu variants, of which the first %u are taken", list.path().c_str(), names_.size(),
                                model::max_texture_sets - 1));
    }
    mapped_.resize(names_.size());
}

void Variants::note(uint32_t material, const JsonView &primitive, size_t material_count)
{
    const JsonView mappings = primitive["extensions"]["KHR_materials_variants"]["mappings"];
    for (size_t i = 0; i < mappings.count(); ++i) {
        const JsonView mapping = mappings.at(i), variants = mapping["variants"];
        const uint32_t to = mapping["material"].index(material_count, "material");
        for (size_t k = 0; k < variants.count(); ++k)
            map(variants.at(k).index(names_.size(), "variant"), material, to, variants.at(k).path());
    }
}

void Variants::map(size_t variant, uint32_t material, uint32_t to, const std::string &path)
{
    const auto [place, is_new] = mapped_[variant].emplace(material, to);
    if (!is_new && place->second != to)
        file_.warn(base::text_of("%s: variant '%s' shows one material in two ways: the first is taken", path.c_str(),
                                 names_[variant].c_str()));
}

}  // namespace claque::asset
