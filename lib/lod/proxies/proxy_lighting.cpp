// split_by_lighting: unlit and emitting surface stays so in proxies (proxy.h).
#include <algorithm>
#include <map>

#include "lib/lod/proxies/proxy.h"

namespace claque::lod
{

using model::Lighting;

namespace
{

Lighting lighting_of(const model::Model &model, const model::Part &part)
{
    return part.material == model::none ? Lighting() : model.materials[part.material].lighting;
}

// Points of a triangle that speak for it.
constexpr double inner = 2.0 / 3, outer = 1.0 / 6, third = 1.0 / 3;
const glm::dvec3 points[] = {{inner, outer, outer}, {outer, inner, outer}, {outer, outer, inner}, glm::dvec3(third)};

using Shares = std::map<Lighting, double>;

Lighting most_of(const Shares &shares)
{
    return std::max_element(shares.begin(), shares.end(),
                            [](const auto &a, const auto &b) { return a.second < b.second; })
        ->first;
}

// By zone, and after the last zone for surface without any: the lighting of most of its visible surface. Zones that no
// point shows have that of most of the character.
std::vector<Lighting> lighting_of_zones(const ProxySource &source)
{
    std::vector<Shares> shares(source.model.zones.size() + 1);
    Shares all;
    for (uint32_t t = 0; t < source.fine.triangles().size(); ++t) {
        const Lighting lighting = lighting_of(source.model, source.fine.part(source.fine.triangles()[t].part));
        const double area = area_of(source.fine, t) * source.visibility[t];
        all[lighting] += area;
        for (const glm::dvec3 &weights : points) {
            if (is_hole(source.model, source.fine, {t, weights})) continue;
            const uint32_t zone = zone_at(source.model, source.fine, {t, weights});
            shares[zone == model::none ? shares.size() - 1 : zone][lighting] += area;
        }
    }
    std::vector<Lighting> out;
    for (const Shares &own : shares) out.push_back(most_of(own.empty() ? all : own));
    return out;
}

Lighting lighting_at(const ProxySource &source, const std::vector<Lighting> &of_zones, const model::Part &part,
                     const uint32_t *corners)
{
    Shares votes;
    for (const glm::dvec3 &weights : points) {
        glm::vec2 uv(0);
        for (int k = 0; k < 3; ++k) uv += static_cast<float>(weights[k]) * part.uvs[corners[k]];
        const uint32_t zone = zone_at(source.model, part, uv);
        votes[of_zones[zone == model::none ? of_zones.size() - 1 : zone]] += 1;
    }
    return most_of(votes);
}

uint32_t material_with(uint32_t material, const Lighting &lighting, model::Model &model)
{
    if (lighting == model.materials[material].lighting) return material;
    for (uint32_t i = 0; i < model.materials.size(); ++i)
        if (model.materials[i].image == model.materials[material].image && model.materials[i].lighting == lighting)
            return i;
    model::Material made = model.materials[material];
    made.lighting = lighting;
    model.materials.push_back(made);
    for (model::TextureSet &set : model.texture_sets) {
        const uint32_t shown = set.images[material];
        set.images.push_back(shown);
    }
    return static_cast<uint32_t>(model.materials.size() - 1);
}

// Adds a triangle with the vertices that `renamed` lacks.
void add_triangle(const model::Part &from, const uint32_t *corners, std::map<uint32_t, uint32_t> &renamed,
                  model::Part &to)
{
    for (int k = 0; k < 3; ++k) {
        const uint32_t v = corners[k];
        const auto [at, fresh] = renamed.try_emplace(v, static_cast<uint32_t>(to.positions.size()));
        to.indices.push_back(at->second);
        if (!fresh) continue;
        to.positions.push_back(from.positions[v]);
        to.normals.push_back(from.normals[v]);
        to.uvs.push_back(from.uvs[v]);
        const size_t n = from.influence_count;
        for (size_t i = n * v; i < n * v + n; ++i)
            to.joints.push_back(from.joints[i]), to.weights.push_back(from.weights[i]);
    }
}

}  // namespace

std::vector<model::Part> split_by_lighting(const ProxySource &source, model::Part part, model::Model &model)
{
    const auto differs = [](const model::Material &material) { return material.lighting != Lighting(); };
    if (std::none_of(model.materials.begin(), model.materials.end(), differs)) return {std::move(part)};
    const std::vector<Lighting> of_zones = lighting_of_zones(source);
    std::map<Lighting, std::vector<size_t>> triangles;
    for (size_t i = 0; i < part.indices.size(); i += 3)
        triangles[lighting_at(source, of_zones, part, &part.indices[i])].push_back(i);
    std::vector<model::Part> out;
    for (const auto &[lighting, own] : triangles) {
        model::Part piece = part;
        piece.positions.clear(), piece.normals.clear(), piece.uvs.clear();
        piece.joints.clear(), piece.weights.clear(), piece.indices.clear();
        piece.material = material_with(part.material, lighting, model);
        std::map<uint32_t, uint32_t> renamed;
        for (const size_t i : own) add_triangle(part, &part.indices[i], renamed, piece);
        out.push_back(std::move(piece));
    }
    return out;
}

}  // namespace claque::lod
