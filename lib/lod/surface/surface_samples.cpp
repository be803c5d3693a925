#include "lib/lod/surface/surface_samples.h"

#include <cmath>
#include <map>
#include <utility>

#include "lib/pose/pose.h"

namespace claque::lod
{

PosedParts::PosedParts(std::vector<const model::Part *> parts) : parts_(std::move(parts))
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < parts_.size(); ++i) {
        first_.push_back(count);
        count += static_cast<uint32_t>(parts_[i]->positions.size());
        for (const auto &t : model::triangles_of(*parts_[i])) triangles_.push_back({i, t});
    }
    positions_.resize(count);
}

void PosedParts::pose(const model::Rig &rig, base::Span<const math::Affine> palette, base::Span<const float> weights)
{
    for (size_t i = 0; i < parts_.size(); ++i) {
        const model::Part &part = *parts_[i];
        for (size_t v = 0; v < part.positions.size(); ++v) {
            glm::dvec3 p(part.positions[v]);
            for (size_t m = 0; part.morph_set != model::none && m < part.morphs.size(); ++m)
                if (!part.morphs[m].positions.empty())
                    p += double(weights[rig.morph_sets[part.morph_set].first_weight + static_cast<uint32_t>(m)]) *
                         glm::dvec3(part.morphs[m].positions[v]);
            glm::dvec3 moved(0);
            for (size_t k = 0; k < part.influence_count; ++k) {
                const double w = double(part.weights[v * part.influence_count + k]);
                if (w == 0) continue;
                const float *c = palette[part.joints[v * part.influence_count + k]].c;
                for (int r = 0; r < 3; ++r)
                    moved[r] +=
                        w * (double(c[r]) * p.x + double(c[3 + r]) * p.y + double(c[6 + r]) * p.z + double(c[9 + r]));
            }
            positions_[first_[i] + v] = moved;
        }
    }
}

std::vector<std::array<glm::dvec3, 3>> PosedParts::corners(const std::vector<uint32_t> &triangles) const
{
    std::vector<std::array<glm::dvec3, 3>> found;
    found.reserve(triangles.size());
    for (const uint32_t t : triangles) found.push_back(corners(triangles_[t]));
    return found;
}

PosedParts posed_at_rest(const model::Rig &rig, std::vector<const model::Part *> parts)
{
    PosedParts posed(std::move(parts));
    pose::Workspace workspace(rig);
    const base::Span<const math::Affine> palette = workspace.pose(model::none, 0);
    posed.pose(rig, palette, workspace.weights());
    return posed;
}

std::vector<std::vector<glm::vec3>> rest_positions(const model::Rig &rig, const std::vector<const model::Part *> &parts)
{
    const PosedParts posed = posed_at_rest(rig, parts);
    std::vector<std::vector<glm::vec3>> out(parts.size());
    for (uint32_t i = 0; i < parts.size(); ++i)
        for (uint32_t v = 0; v < parts[i]->positions.size(); ++v) out[i].emplace_back(posed.vertex(i, v));
    return out;
}

glm::dvec3 position_of(const PosedParts &parts, const SurfacePoint &point)
{
    const PosedParts::Triangle &t = parts.triangles()[point.triangle];
    return point.weights.x * parts.corner(t, 0) + point.weights.y * parts.corner(t, 1) +
           point.weights.z * parts.corner(t, 2);
}

uint32_t texel_index(double at, uint32_t size, model::Wrap wrap)
{
    const double n = double(size);
    double x = std::floor(at * n);
    if (wrap == model::Wrap::repeat) x -= n * std::floor(x / n);
    if (wrap == model::Wrap::mirror) {
        x -= 2 * n * std::floor(x / (2 * n));
        if (x >= n) x = 2 * n - 1 - x;
    }
    return static_cast<uint32_t>(std::fmin(std::fmax(x, 0), n - 1));
}

glm::dvec2 uv_at(const PosedParts &parts, const SurfacePoint &point)
{
    const PosedParts::Triangle &t = parts.triangles()[point.triangle];
    const model::Part &part = parts.part(t.part);
    glm::dvec2 uv(0);
    for (size_t k = 0; k < 3 && !part.uvs.empty(); ++k)
        uv += point.weights[static_cast<int>(k)] * glm::dvec2(part.uvs[t.vertices[k]]);
    return uv;
}

namespace
{

// Returns model::none if the material has no image.
uint32_t image_of(const model::Model &model, uint32_t material, const model::TextureSet *set)
{
    const bool other = set && material < set->images.size() && set->images[material] != model::none;
    return other ? set->images[material] : model.materials[material].image;
}

const uint8_t *texel_of(const model::Model &model, const model::Part &part, glm::dvec2 uv, const model::TextureSet *set)
{
    if (part.material == model::none || part.uvs.empty()) return nullptr;
    const model::Material &material = model.materials[part.material];
    const uint32_t shown = image_of(model, part.material, set);
    if (shown == model::none) return nullptr;
    const model::Image &image = model.images[shown];
    const size_t x = texel_index(uv.x, image.width, material.wrap_s),
                 y = texel_index(uv.y, image.height, material.wrap_t);
    return image.rgba.data() + 4 * (y * image.width + x);
}

uint32_t zone_of_texel(const model::Model &model, const model::Part &part, const uint8_t *found,
                       const model::TextureSet *set)
{
    if (part.material == model::none) return model::none;
    if (!found || model.images[image_of(model, part.material, set)].alpha != model::AlphaMeaning::zone_keys)
        return model.materials[part.material].zone;
    for (uint32_t zone = 0; zone < model.zones.size(); ++zone)
        if (model.zones[zone].key == found[3]) return zone;
    return model::none;
}

}  // namespace

uint32_t zone_at(const model::Model &model, const PosedParts &parts, const SurfacePoint &point,
                 const model::TextureSet *set)
{
    const model::Part &part = parts.part(parts.triangles()[point.triangle].part);
    return zone_of_texel(model, part, texel_of(model, part, uv_at(parts, point), set), set);
}

uint32_t zone_at(const model::Model &model, const model::Part &part, glm::vec2 uv, const model::TextureSet *set)
{
    return zone_of_texel(model, part, texel_of(model, part, glm::dvec2(uv), set), set);
}

bool has_holes(const model::Model &model, const model::Part &part)
{
    if (part.material == model::none) return false;
    const model::Material &material = model.materials[part.material];
    return material.alpha_mode == model::AlphaMode::mask && material.image != model::none &&
           model.images[material.image].alpha != model::AlphaMeaning::zone_keys;
}

bool is_hole(const model::Model &model, const model::Part &part, glm::dvec2 uv, const model::TextureSet *set)
{
    if (!has_holes(model, part)) return false;
    const uint8_t *found = texel_of(model, part, uv, set);
    return found && float(found[3]) < 255 * model.materials[part.material].alpha_cutoff;
}

bool is_hole(const model::Model &model, const PosedParts &parts, const SurfacePoint &point,
             const model::TextureSet *set)
{
    return is_hole(model, parts.part(parts.triangles()[point.triangle].part), uv_at(parts, point), set);
}

glm::dvec3 texel_at(const model::Model &model, const PosedParts &parts, const SurfacePoint &point,
                    const model::TextureSet *set)
{
    const model::Part &part = parts.part(parts.triangles()[point.triangle].part);
    const uint8_t *found = texel_of(model, part, uv_at(parts, point), set);
    return found ? glm::dvec3(found[0], found[1], found[2]) / 255.0 : glm::dvec3(1);
}

std::vector<std::vector<uint32_t>> neighbours_of(const PosedParts &parts)
{
    std::vector<std::vector<uint32_t>> beside(parts.triangles().size());
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> edges;
    for (uint32_t t = 0; t < beside.size(); ++t)
        for (size_t k = 0; k < 3; ++k) {
            const std::array<uint32_t, 3> v = parts.vertices_of(t);
            const auto there = edges.find({v[(k + 1) % 3], v[k]});
            if (there == edges.end()) {
                edges[{v[k], v[(k + 1) % 3]}] = t;
                continue;
            }
            beside[t].push_back(there->second), beside[there->second].push_back(t);
        }
    return beside;
}

}  // namespace claque::lod
