// Reads KHR_materials_variants as texture sets. Only the image of a variant's material is used, since individuals of
// one template can differ in images alone.
#pragma once

#include <map>

#include "lib/asset/gltf_file.h"

namespace claque::asset
{

class Variants
{
public:
    explicit Variants(File &file);

    // Records the materials that variants give to a primitive that shows `material`. Throws base::Error (FORMAT) if the
    // mapping breaks a rule of the format.
    void note(uint32_t material, const JsonView &primitive, size_t material_count);

    size_t count() const { return names_.size(); }
    const std::string &name(size_t variant) const { return names_[variant]; }
    // By material: the material that a variant shows instead. Unchanged materials are missing.
    const std::map<uint32_t, uint32_t> &mapped(size_t variant) const { return mapped_[variant]; }

private:
    void map(size_t variant, uint32_t material, uint32_t to, const std::string &path);

    File &file_;
    std::vector<std::string> names_;
    std::vector<std::map<uint32_t, uint32_t>> mapped_;
};

}  // namespace claque::asset
