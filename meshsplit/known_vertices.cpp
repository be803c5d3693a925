#include "meshsplit/known_vertices.h"

namespace claque::meshsplit
{
namespace
{

// The bytes of its position, joints and weights.
std::string bytes_of(const model::Level &level, uint32_t vertex, uint32_t first_influence, uint32_t influences)
{
    std::string bytes;
    const auto add = [&](const auto *from, size_t count) {
        bytes.append(reinterpret_cast<const char *>(from), count * sizeof *from);
    };
    add(level.positions.data() + 3 * size_t(vertex), 3);
    add(level.joints.data() + first_influence, influences);
    add(level.weights.data() + first_influence, influences);
    return bytes;
}

}  // namespace

std::vector<uint8_t> KnownVertices::among(const model::Level &level)
{
    std::vector<uint8_t> known(level.source_count);
    if (!level.morph_deltas.empty()) return known;
    uint32_t v = 0;
    for (const model::InfluenceRun &run : level.runs)
        for (uint32_t i = 0; i < run.count; ++i, ++v)
            known[v] =
                !seen_.insert(bytes_of(level, v, run.first_influence + i * run.influences, run.influences)).second;
    return known;
}

}  // namespace claque::meshsplit
