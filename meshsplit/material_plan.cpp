#include "meshsplit/material_plan.h"

#include <algorithm>
#include <cmath>
#include <set>

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

bool close(const Rgb &a, const Rgb &b)
{
    for (size_t k = 0; k < 3; ++k)
        if (std::fabs(a[k] - b[k]) > 1.0f / 512.0f) return false;
    return true;
}

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
        const size_t given = out_.zones.size();
        for (size_t i = 0; i < materials_.size(); ++i) {
            Material &material = materials_[i];
            if (!uses_[i].used || has_keys(material) || material.zone != none) continue;
            const Rgb colour = base_of(material);
            for (size_t z = given; z < out_.zones.size() && material.zone == none; ++z)
                if (out_.zones[z].colour == colour) material.zone = static_cast<uint32_t>(z);
            if (material.zone == none) material.zone = add_zone(material.name, colour);
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
        for (size_t z = 0; z < out_.zones.size(); ++z) {
            std::vector<size_t> members;
            bool holds_base = false;
            for (size_t i = 0; i < materials_.size(); ++i)
                if (uses_[i].used && !has_keys(materials_[i]) && materials_[i].zone == z) {
                    members.push_back(i);
                    holds_base = holds_base || close(rgb_[i], out_.zones[z].colour);
                }
            if (holds_base) share_colour(members, out_.zones[z].colour);
        }
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
        for (size_t t = 0; t < out_.textures.size(); ++t)
            if (out_.textures[t].same_texture(plan)) return static_cast<uint32_t>(t);
        out_.textures.push_back(plan);
        return static_cast<uint32_t>(out_.textures.size() - 1);
    }

    void plan_cell(size_t i)
    {
        const Material &material = materials_[i];
        Cell cell{material.zone, rgb_[i], false};
        cell.is_hole = material.alpha_mode == model::AlphaMode::mask && material.base_colour[3] < material.alpha_cutoff;
        const uint32_t texture = palette_for(cell.zone);
        std::vector<Cell> &cells = out_.textures[texture].cells;
        size_t at = 0;
        while (at < cells.size() &&
               !(cells[at].zone == cell.zone && close(cells[at].rgb, cell.rgb) && cells[at].is_hole == cell.is_hole))
            ++at;
        if (at == cells.size()) cells.push_back(cell);
        out_.mappings[i].texture = texture;
        palette_mappings_.push_back({i, static_cast<uint32_t>(at)});
    }

    // Returns the first palette that has the zone or room for it; a new one if there is none.
    uint32_t palette_for(uint32_t zone)
    {
        for (size_t t = 0; t < out_.textures.size(); ++t) {
            if (out_.textures[t].image != none) continue;
            std::set<uint32_t> zones = {zone};
            for (const Cell &cell : out_.textures[t].cells) zones.insert(cell.zone);
            if (zones.size() <= max_palette_zones) return static_cast<uint32_t>(t);
        }
        TexturePlan plan;
        plan.wrap_s = plan.wrap_t = Wrap::clamp;
        out_.textures.push_back(plan);
        return static_cast<uint32_t>(out_.textures.size() - 1);
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
    MaterialPlan out_;
};

}  // namespace

bool TexturePlan::same_texture(const TexturePlan &other) const
{
    return image != none && image == other.image && others == other.others && wrap_s == other.wrap_s &&
           wrap_t == other.wrap_t && zone == other.zone && close(rgb, other.rgb) && masked == other.masked &&
           cutoff == other.cutoff;
}

uint32_t palette_side(uint32_t cell_count)
{
    uint32_t side = 1;
    while (side * side < cell_count) side *= 2;
    return side;
}

MaterialPlan plan_materials(const model::Model &model) { return MaterialPlanner(model).run(); }

}  // namespace claque::meshsplit
