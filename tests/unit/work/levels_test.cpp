// The bound of docs/levels.md: making levels takes work in proportion to the triangles, with room for searches that
// grow with their depth. Work is counted, never timed.
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/lod/chain.h"
#include "work_counter.h"

namespace claque::testing
{
namespace
{

// Basic blocks: for any model, and for each triangle.
constexpr uint64_t always_blocks = 2ull << 30, blocks_of_triangle = 6000000;
// How much more work each triangle may take where there are ten times as many: n log n, with room for what does not
// grow evenly.
constexpr double most_growth = 1.6;
// Of a level of 20 triangles, for each material.
constexpr double most_blocks_of_material = 50e6;

enum class Shape { net, loose, layers, needles };

// `moving`: on two nodes that a clip moves, so that proxies are made.
model::Model shape_of(Shape shape, size_t count, bool moving)
{
    model::Model model;
    model.name = "shape";
    const uint32_t nodes = moving ? 2 : 1;
    for (uint32_t n = 0; n < nodes; ++n) {
        model.rig.parents.push_back(model::none);
        model.rig.rest.emplace_back();
        model.rig.node_names.emplace_back("node");
        model.rig.palette.emplace_back();
        model.rig.palette.back().node = n;
    }
    model.materials.emplace_back();
    model.source_bytes = 1 << 30;  // what it may take in memory is not asked here
    const size_t side = static_cast<size_t>(std::sqrt(double(count) / (2 * nodes))) + 1;
    for (uint32_t n = 0; n < nodes; ++n) {
        model::Part &part = model.parts.emplace_back();
        part.material = 0, part.node = n;
        for (size_t i = 0; i < side * side; ++i) {
            const float x = float(i % side) / float(side), y = float(i / side) / float(side), step = 1 / float(side);
            if (shape == Shape::net) {
                part.positions.emplace_back(x + float(n), y, 0.05f * std::sin(20 * x) * std::cos(17 * y));
                if (i % side + 1 == side || i / side + 1 == side) continue;
                for (const size_t corner : {i, i + 1, i + side, i + 1, i + side + 1, i + side})
                    part.indices.push_back(static_cast<uint32_t>(corner));
                continue;
            }
            const float z = shape == Shape::layers ? float(i % 400) * 1e-3f : 0.1f * std::sin(float(i));
            const float wide = shape == Shape::layers ? 1 : shape == Shape::needles ? 0.9f : step;
            const float high = shape == Shape::needles ? 0.1f * step : wide;
            const float left = shape == Shape::layers ? 0 : x,
                        low = shape == Shape::layers ? 1.01f * std::floor(float(i) / 400) : y;
            for (const glm::vec2 corner : {glm::vec2(0), glm::vec2(wide, 0), glm::vec2(0, high), glm::vec2(wide, high),
                                           glm::vec2(0, high), glm::vec2(wide, 0)})
                part.positions.emplace_back(left + corner.x + float(n), low + corner.y, z);
        }
        part.joints.assign(part.positions.size(), n), part.weights.assign(part.positions.size(), 1.0f);
    }
    return model;
}

// The net of shape_of in parts that lie beside each other, each with a material and a zone of its own.
model::Model patched(size_t count, uint32_t materials)
{
    model::Model model = shape_of(Shape::net, count, true);
    const std::vector<model::Part> nets = std::move(model.parts);
    model.parts.clear(), model.materials.clear();
    for (uint32_t i = 0; i < materials; ++i) {
        model.zones.emplace_back().name = "zone";
        model.materials.emplace_back().zone = i;
        const model::Part &net = nets[i % nets.size()];
        const size_t here = i / nets.size(), all = (materials + 1) / nets.size(), triangles = net.indices.size() / 3;
        model::Part &part = model.parts.emplace_back();
        part.material = i, part.node = net.node;
        std::map<uint32_t, uint32_t> renamed;
        for (size_t k = 3 * (here * triangles / all); k < 3 * ((here + 1) * triangles / all); ++k) {
            const auto [at, is_new] = renamed.try_emplace(net.indices[k], static_cast<uint32_t>(renamed.size()));
            if (is_new) part.positions.push_back(net.positions[net.indices[k]]);
            part.indices.push_back(at->second);
        }
        part.joints.assign(part.positions.size(), net.node), part.weights.assign(part.positions.size(), 1.0f);
    }
    return model;
}

struct Work {
    double triangles = 0, blocks = 0;
};

Work work_of(model::Model model, const lod::ChainOptions &options = {})
{
    size_t triangles = 0;
    for (const model::Part &part : model.parts) triangles += model::triangles_of(part).size();
    std::string refused;
    const uint64_t work = blocks_entered([&] {
        try {
            lod::make_chain(model, options);
        } catch (const base::Error &error) {
            refused = error.what();
        }
    });
    EXPECT_EQ(refused, "");
    EXPECT_LE(work, always_blocks + blocks_of_triangle * triangles) << triangles;
    return {double(triangles), double(work)};
}

TEST(LevelsWork, IsBoundedByTheTriangles)
{
    for (const Shape shape : {Shape::net, Shape::loose, Shape::layers, Shape::needles})
        for (const bool moving : {false, true})
            for (const size_t count : {150, 700}) work_of(shape_of(shape, count, moving));
}

// Proxies are left out: most of their work does not depend on the number of triangles, and would hide the growth.
TEST(LevelsWork, GrowsWithTheTrianglesAndTheDepthOfSearches)
{
    for (const Shape shape : {Shape::net, Shape::loose, Shape::layers, Shape::needles}) {
        const Work few = work_of(shape_of(shape, 300, false)), many = work_of(shape_of(shape, 3000, false));
        EXPECT_GT(few.blocks, 1e6) << "nothing is counted";
        const double ratio = (many.blocks / many.triangles) / (few.blocks / few.triangles);
        RecordProperty("shape " + std::to_string(int(shape)), std::to_string(ratio));
        EXPECT_LE(ratio, most_growth) << "shape " << int(shape);
    }
}

// Zones of coarse levels are searched among all materials, whose combinations are as many as the third power of
// triangles times materials.
TEST(LevelsWork, OfZonesIsBoundedWhateverTheMaterials)
{
    lod::ChainOptions options;
    options.targets = {20};
    const Work few = work_of(patched(300, 2), options), many = work_of(patched(300, 30), options);
    RecordProperty("ratio", std::to_string(many.blocks / few.blocks));
    EXPECT_LE(many.blocks, few.blocks + 30 * most_blocks_of_material);
}

TEST(LevelsWork, GrowsAtMostWithTheMaterialsAndTheTriangles)
{
    lod::ChainOptions options;
    options.targets = {250, 120, 42, 20};
    const Work few = work_of(patched(300, 15), options), materials = work_of(patched(300, 60), options),
               both = work_of(patched(1200, 60), options);
    RecordProperty(
        "ratios", std::to_string(materials.blocks / few.blocks) + " " + std::to_string(both.blocks / materials.blocks));
    EXPECT_LE(materials.blocks, 4 * few.blocks);
    EXPECT_LE(both.blocks, 4 * materials.blocks);
}

}  // namespace
}  // namespace claque::testing
