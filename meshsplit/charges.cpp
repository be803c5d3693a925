#include "meshsplit/charges.h"

#include <algorithm>

#include "meshsplit/pyramid.h"

namespace claque::meshsplit
{

namespace
{

using model::none;
using model::Wrap;

// Bytes that a level keeps, and that making its mesh takes for a while (sources, welding, sorting), in arrays that
// grow.
struct Cost {
    uint64_t vertex, influence, morph, triangle;
};
constexpr Cost kept = {180, 24, 120, 130}, passing = {260, 40, 90, 120};
// Per texel of a source while gutters are filled, of a texture in each texture set, and of a finished texture.
constexpr uint64_t source_texel_bytes = 26, set_texel_bytes = 10, final_texel_bytes = 4 + 2;

uint64_t triangle_count(const model::Part &part)
{
    const uint64_t n = part.indices.empty() ? part.positions.size() : part.indices.size();
    if (part.topology < model::Topology::triangles) return 0;
    return part.topology == model::Topology::triangles ? n / 3 : n;
}

// Flat normals make vertices of corners.
uint64_t part_bytes(const model::Part &part, const Cost &cost)
{
    const uint64_t triangles = triangle_count(part), corners = 3 * triangles;
    const uint64_t vertices = part.normals.empty() ? corners : std::min<uint64_t>(part.positions.size(), corners);
    return triangles * cost.triangle +
           vertices * (cost.vertex + cost.influence * part.influence_count + cost.morph * part.morphs.size());
}

}  // namespace

void charge_meshes(const model::Model &model, const std::vector<LevelPlan> &plans, Allowance &allowance)
{
    uint64_t sum = 0, once = 0;
    for (const model::Part &part : model.parts)
        if (!part.hidden) sum += part_bytes(part, kept), once += part_bytes(part, passing);
    if (plans.size() > 1)
        for (const LevelPlan &plan : plans)
            for (const uint32_t part : plan.parts) sum += part_bytes(model.parts[part], kept);
    allowance.take(sum + once, "the meshes of all levels");
}

void charge_textures(const model::Model &model, const MaterialPlan &materials, uint32_t max_px, Allowance &allowance)
{
    uint64_t made = 0, maximum = 0;
    for (const TexturePlan &plan : materials.textures) {
        if (plan.image == none) {
            const uint64_t side = uint64_t(cell_px) * palette_side(static_cast<uint32_t>(plan.cells.size()));
            made += side * side * final_texel_bytes;
            continue;
        }
        std::vector<uint32_t> images = {plan.image};
        for (const uint32_t other : plan.others) images.push_back(other == none ? plan.image : other);
        if (std::all_of(images.begin(), images.end(), [&](uint32_t i) { return i == plan.image; })) images.resize(1);
        uint64_t sets = 0, source = 0;
        for (const uint32_t i : images) {
            const uint32_t width = model.images[i].width * (plan.wrap_s == Wrap::mirror ? 2 : 1);
            const uint32_t height = model.images[i].height * (plan.wrap_t == Wrap::mirror ? 2 : 1);
            const uint64_t fitted = uint64_t(fitted_side(width, max_px)) * fitted_side(height, max_px);
            made += fitted * final_texel_bytes;
            sets += fitted * set_texel_bytes;
            source = std::max(source, uint64_t(width) * height * source_texel_bytes);
        }
        maximum = std::max(maximum, sets + source);
    }
    allowance.take(made + maximum, "the textures");
}

}  // namespace claque::meshsplit
