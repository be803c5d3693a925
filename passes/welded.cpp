#include "passes/welded.h"

#include <cstring>
#include <map>
#include <numeric>

namespace claque::passes
{
namespace
{

bool at_one_texel(const model::Level &level, const uint32_t *corners)
{
    const auto uv = [&](int k) { return level.uvs.data() + 2 * size_t(corners[k]); };
    return std::memcmp(uv(0), uv(1), 2 * sizeof(float)) == 0 && std::memcmp(uv(0), uv(2), 2 * sizeof(float)) == 0;
}

using Bits = std::vector<uint32_t>;

void add_bits(Bits &bits, const float *values, size_t count)
{
    const size_t at = bits.size();
    bits.resize(at + count);
    std::memcpy(bits.data() + at, values, count * sizeof(float));
}

}  // namespace

bool shows_texels(const model::Level &level, uint32_t max_triangles)
{
    if (level.surfaces.size() != 1 || !level.colours.empty() || !level.copies.empty() ||
        level.positions.size() != 3 * size_t(level.source_count))
        return false;
    const model::Surface &surface = level.surfaces[0];
    if (surface.dirty.count != 0 || surface.fused.count == 0 || surface.fused.count > 3 * uint64_t(max_triangles))
        return false;
    for (uint32_t i = 0; i < surface.fused.count; i += 3)
        if (!at_one_texel(level, level.indices.data() + surface.fused.first + i)) return false;
    return true;
}

std::vector<uint32_t> welded_vertices(const model::Level &level)
{
    std::vector<uint32_t> welded(level.source_count);
    std::iota(welded.begin(), welded.end(), 0u);
    if (!level.morph_deltas.empty()) return welded;
    std::map<Bits, uint32_t> first;
    for (const model::InfluenceRun &run : level.runs)
        for (uint32_t v = run.first; v < run.first + run.count; ++v) {
            const size_t at = run.first_influence + size_t(v - run.first) * run.influences;
            Bits bits(level.joints.begin() + std::ptrdiff_t(at),
                      level.joints.begin() + std::ptrdiff_t(at + run.influences));
            add_bits(bits, level.weights.data() + at, run.influences);
            add_bits(bits, level.positions.data() + 3 * size_t(v), 3);
            welded[v] = first.emplace(std::move(bits), v).first->second;
        }
    return welded;
}

}  // namespace claque::passes
