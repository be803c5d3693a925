// KHR_materials_variants as texture sets: of another material only its image counts, since that is what can differ between
// individuals of one template.
#pragma once

#include <map>

#include "lib/asset/gltf_file.h"

namespace claque::asset
{

class Variants
{
public:
    explicit Variants(File &file);

    // What a primitive that shows `material` maps to. Throws base::Error (FORMAT) where that breaks the format's rules.
    void note(uint32_t material, const JsonView &primitive, size_t material_count);

    size_t count() const { return names_.size(); }
    const std::string &name(size_t variant) const { return names_[variant]; }
    // By material: the one that a variant shows in its place; those that it leaves alone are missing.
    const std::map<uint32_t, uint32_t> &mapped(size_t variant) const { return mapped_[variant]; }

private:
    void map(size_t variant, uint32_t material, uint32_t to, const std::string &path);

    File &file_;
    std::vector<std::string> names_;
    std::vector<std::map<uint32_t, uint32_t>> mapped_;
};

}  // namespace claque::asset
