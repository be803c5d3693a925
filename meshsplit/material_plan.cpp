#include "meshsplit/material_plan.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "lib/base/error.h"
#include "meshsplit/zone_map.h"

namespace claque::meshsplit
{

using model::Material;
using model::none;
using model::Wrap;

namespace
{

struct UvRange {
    bool used = false;
    glm::vec2 low = glm::vec2(0), high = glm::vec2(0);
    void add(glm::vec2 uv)
    {
        low = used ? glm::min(low, uv) : uv;
        high = used ? glm::max(high, uv) : uv;
        used = true;
    }
};

Rgb base_of(const Material &material)
{
    Rgb rgb;
    for (size_t k = 0; k < 3; ++k) rgb[k] = std::clamp(material.base_colour[k], 0.0f, 1.0f);
    return rgb;
}

// Returns the range of this colour alone.
model::HsbRange range_of(const Rgb &c)
{
    const float top = std::max({c[0], c[1], c[2]}), spread = top - std::min({c[0], c[1], c[2]});
    float hue = 0;
    if (spread > 0) {
        if (top == c[0]) hue = (c[1] - c[2]) / spread;
        else if (top == c[1]) hue = 2 + (c[2] - c[0]) / spread;
        else hue = 4 + (c[0] - c[1]) / spread;
        hue = hue < 0 ? 60 * (hue + 6) : 60 * hue;
    }
    const float saturation = top > 0 ? spread / top : 0;
    return {hue, hue, saturation, saturation, top, top};
}

class MaterialPlanner
{
public:
    explicit MaterialPlanner(const model::Model &model) : model_(model), materials_(model.materials)
    {
        materials_.push_back(Material());  // for parts without a material
        materials_.back().name = "default";
        out_.zones = model.zones;
        out_.mappings.resize(materials_.size());
    }

    MaterialPlan run()
    {
        find_uses();
        name_zones();
        settle_colours();
        for (size_t i = 0; i < materials_.size(); ++i)
            if (uses_[i].used) plan(i);
        place_cells();
        return std::move(out_);
    }

private:
    bool has_keys(const Material &material) const
    {
        return material.image != none && model_.images[material.image].alpha == model::AlphaMeaning::zone_keys;
    }

    void find_uses()
    {
        uses_.resize(materials_.size());
        for (const model::Part &part : model_.parts) {
            if (part.hidden) continue;
            UvRange &use = uses_[part.material == none ? materials_.size() - 1 : part.material];
            for (const auto &triangle : model::triangles_of(part))
                for (const uint32_t v : triangle) use.add(part.uvs.empty() ? glm::vec2(0) : part.uvs[v]);
        }
    }

    // Materials without a zone get one zone per base colour.
    void name_zones()
    {
        std::map<Rgb, uint32_t> made;
        for (size_t i = 0; i < materials_.size(); ++i) {
            Material &material = materials_[i];
            if (!uses_[i].used || has_keys(material) || material.zone != none) continue;
            const Rgb colour = base_of(material);
            const auto [place, is_new] = made.emplace(colour, 0u);
            if (is_new) place->second = add_zone(material.name, colour);
            material.zone = place->second;
        }
        if (out_.zones.size() >= hole)
            base::fail(CLQ_LIMIT, "%zu zones: a template can have at most %u", out_.zones.size(), hole - 1u);
    }

    uint32_t add_zone(const std::string &name, const Rgb &colour)
    {
        model::Zone zone;
        zone.name = name;
        zone.colour = colour;
        zone.range = range_of(colour);
        out_.zones.push_back(zone);
        return static_cast<uint32_t>(out_.zones.size() - 1);
    }

    void settle_colours()
    {
        rgb_.resize(materials_.size());
        for (size_t i = 0; i < materials_.size(); ++i) rgb_[i] = base_of(materials_[i]);
        std::vector<std::vector<size_t>> members(out_.zones.size());
        for (size_t i = 0; i < materials_.size(); ++i)
            if (uses_[i].used && !has_keys(materials_[i]) && materials_[i].zone != none)
                members[materials_[i].zone].push_back(i);
        for (size_t z = 0; z < members.size(); ++z)
            if (std::any_of(members[z].begin(), members[z].end(),
                            [&](size_t i) { return close(rgb_[i], out_.zones[z].colour); }))
                share_colour(members[z], out_.zones[z].colour);
    }

    void share_colour(const std::vector<size_t> &members, Rgb &colour)
    {
        for (const size_t i : members)
            for (size_t k = 0; k < 3; ++k) colour[k] = std::max(colour[k], rgb_[i][k]);
        for (const size_t i : members) {
            if (close(rgb_[i], colour)) rgb_[i] = {1, 1, 1};
            else
                for (size_t k = 0; k < 3; ++k) rgb_[i][k] = colour[k] > 0 ? rgb_[i][k] / colour[k] : 1.0f;
        }
    }

    void plan(size_t i)
    {
        const Material &material = materials_[i];
        out_.mappings[i].double_sided = material.double_sided;
        out_.mappings[i].lighting = lighting_of(i);
        if (material.image == none) return plan_cell(i);
        TexturePlan plan;
        plan.image = material.image;
        for (const model::TextureSet &set : model_.texture_sets)
            plan.others.push_back(i < set.images.size() && set.images[i] != material.image ? set.images[i] : none);
        plan.wrap_s = wrap_of(material.wrap_s, uses_[i].low.x, uses_[i].high.x);
        plan.wrap_t = wrap_of(material.wrap_t, uses_[i].low.y, uses_[i].high.y);
        plan.rgb = rgb_[i];
        if (!has_keys(material)) {
            plan.zone = material.zone;
            plan.masked = material.alpha_mode == model::AlphaMode::mask;
            if (plan.masked) plan.cutoff = cutoff_of(material);
        }
        out_.mappings[i].texture = place(plan);
        if (plan.wrap_s == Wrap::mirror) out_.mappings[i].uv_scale.x = 0.5f;
        if (plan.wrap_t == Wrap::mirror) out_.mappings[i].uv_scale.y = 0.5f;
    }

    // GL multiplies emission by the texture, which contains a factor of the base colour.
    model::Lighting lighting_of(size_t i) const
    {
        model::Lighting lighting = materials_[i].lighting;
        for (size_t k = 0; k < 3; ++k)
            if (rgb_[i][k] > 0) lighting.emission[k] = std::min(lighting.emission[k] / rgb_[i][k], 1.0f);
        return lighting;
    }

    // Within [0, 1] mirroring looks like clamping, and clamping needs no texture of twice the size.
    static Wrap wrap_of(Wrap wrap, float low, float high)
    {
        return wrap == Wrap::mirror && low >= 0 && high <= 1 ? Wrap::clamp : wrap;
    }

    static float cutoff_of(const Material &material)
    {
        const float alpha = std::max(material.base_colour[3], 0.0f);
        return alpha > 0 ? material.alpha_cutoff / alpha : material.alpha_cutoff > 0 ? 2.0f : 0.0f;
    }

    uint32_t place(const TexturePlan &plan)
    {
        const uint32_t next = static_cast<uint32_t>(out_.textures.size());
        const uint32_t texture = near_textures_.number(plan.family(), plan.rgb, next);
        if (texture == next) out_.textures.push_back(plan);
        return texture;
    }

    void plan_cell(size_t i)
    {
        const Material &material = materials_[i];
        Cell cell{material.zone, rgb_[i], false};
        cell.is_hole = material.alpha_mode == model::AlphaMode::mask && material.base_colour[3] < material.alpha_cutoff;
        const uint32_t texture = palette_for(cell.zone);
        std::vector<Cell> &cells = out_.textures[texture].cells;
        const std::string family = base::text_of("%u %u %d", texture, cell.zone, int(cell.is_hole));
        const uint32_t at = near_cells_.number(family, cell.rgb, static_cast<uint32_t>(cells.size()));
        if (at == cells.size()) cells.push_back(cell);
        out_.mappings[i].texture = texture;
        palette_mappings_.push_back({i, at});
    }

    // Returns the palette that has the zone, the last one if it has room, or else a new one.
    uint32_t palette_for(uint32_t zone)
    {
        const auto [place, is_new] = palettes_.emplace(zone, last_palette_);
        if (!is_new) return place->second;
        if (last_palette_ == none || ++zones_of_last_ > max_palette_zones) {
            TexturePlan plan;
            plan.wrap_s = plan.wrap_t = Wrap::clamp;
            last_palette_ = static_cast<uint32_t>(out_.textures.size()), zones_of_last_ = 1;
            out_.textures.push_back(plan);
        }
        return place->second = last_palette_;
    }

    void place_cells()
    {
        for (const auto &[i, cell] : palette_mappings_) {
            MaterialMapping &mapping = out_.mappings[i];
            const uint32_t side = palette_side(static_cast<uint32_t>(out_.textures[mapping.texture].cells.size()));
            mapping.uv_scale = glm::vec2(0);
            mapping.uv_offset =
                glm::vec2((float(cell % side) + 0.5f) / float(side), (float(cell / side) + 0.5f) / float(side));
        }
    }

    struct PaletteMapping {
        size_t mapping;
        uint32_t cell;
    };

    const model::Model &model_;
    std::vector<Material> materials_;
    std::vector<UvRange> uses_;
    std::vector<Rgb> rgb_;  // per material: the factor of its base colour that the texture contains
    std::vector<PaletteMapping> palette_mappings_;
    NearColours near_textures_, near_cells_;
    std::unordered_map<uint32_t, uint32_t> palettes_;  // by zone
    uint32_t last_palette_ = none;                     // the only one with room
    uint32_t zones_of_last_ = 0;
    MaterialPlan out_;
};

}  // namespace

std::string TexturePlan::family() const
{
    std::string out = base::text_of("%u %u %u %u %d %a", image, unsigned(wrap_s), unsigned(wrap_t), zone, int(masked),
                                    double(cutoff));
    for (const uint32_t other : others) out += ',' + std::to_string(other);
    return out;
}

uint32_t palette_side(uint32_t cell_count)
{
    uint32_t side = 1;
    while (side * side < cell_count) side *= 2;
    return side;
}

MaterialPlan plan_materials(const model::Model &model) { return MaterialPlanner(model).run(); }

}  // namespace claque::meshsplit
