// The bound of docs/levels.md: making levels takes work in proportion to the triangles, with room for searches that
// grow with their depth. Work is counted, never timed.
#include <cmath>

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

struct Work {
    double triangles = 0, blocks = 0;
};

Work work_of(Shape shape, size_t count, bool moving)
{
    model::Model model = shape_of(shape, count, moving);
    size_t triangles = 0;
    for (const model::Part &part : model.parts) triangles += model::triangles_of(part).size();
    std::string refused;
    const uint64_t work = blocks_entered([&] {
        try {
            lod::make_chain(model, {});
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
            for (const size_t count : {150, 700}) work_of(shape, count, moving);
}

// Proxies are left out: most of their work does not depend on the number of triangles, and would hide the growth.
TEST(LevelsWork, GrowsWithTheTrianglesAndTheDepthOfSearches)
{
    for (const Shape shape : {Shape::net, Shape::loose, Shape::layers, Shape::needles}) {
        const Work few = work_of(shape, 300, false), many = work_of(shape, 3000, false);
        EXPECT_GT(few.blocks, 1e6) << "nothing is counted";
        const double ratio = (many.blocks / many.triangles) / (few.blocks / few.triangles);
        RecordProperty("shape " + std::to_string(int(shape)), std::to_string(ratio));
        EXPECT_LE(ratio, most_growth) << "shape " << int(shape);
    }
}

}  // namespace
}  // namespace claque::testing
