// Triangles that lie on one another are refused before anything takes the square of their number.
#include "lib/lod/surface/stacking.h"

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/lod/chain.h"

namespace claque
{

namespace
{

std::vector<lod::Corners3> sheet(size_t count, double step)
{
    std::vector<lod::Corners3> out;
    for (size_t i = 0; i < count; ++i) {
        const double x = double(i % 100) * step, y = double(i / 100) * step, z = double(i) * 1e-9;
        out.push_back({glm::dvec3(x, y, z), glm::dvec3(x + 1, y, z), glm::dvec3(x, y + 1, z)});
    }
    return out;
}

std::string refusal(const std::vector<lod::Corners3> &triangles)
{
    try {
        lod::check_stacking(triangles, "heap");
        return "";
    } catch (const base::Error &error) {
        EXPECT_EQ(error.status(), CLQ_LIMIT);
        return error.what();
    }
}

// Triangles of one place, as many as stated, and nothing else.
model::Model heap_of(size_t count)
{
    model::Model model;
    model.name = "heap";
    model.rig.parents.push_back(model::none);
    model.rig.rest.emplace_back();
    model.rig.node_names.emplace_back("node");
    model.rig.palette.emplace_back();
    model.materials.emplace_back();
    model.source_bytes = 1 << 30;  // what levels take in memory is not asked here
    model::Part &part = model.parts.emplace_back();
    part.material = 0, part.node = 0;
    for (size_t i = 0; i < count; ++i)
        for (const glm::vec3 corner : {glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)})
            part.positions.push_back(corner);
    part.joints.assign(3 * count, 0), part.weights.assign(3 * count, 1.0f);
    return model;
}

}  // namespace

TEST(Stacking, OfTwentyThousandTrianglesIsRefusedWithNumbers)
{
    for (const double step : {0.0, 1e-6}) {
        const std::string text = refusal(sheet(20000, step));
        EXPECT_NE(text.find("'heap' has 20000 triangles"), std::string::npos) << text;
        EXPECT_NE(text.find("512"), std::string::npos) << text;
    }
}

TEST(Stacking, OfACharactersTrianglesRefusesItsLevels)
{
    model::Model model = heap_of(3000);
    try {
        lod::make_chain(model, {});
        ADD_FAILURE() << "levels were made";
    } catch (const base::Error &error) {
        EXPECT_EQ(error.status(), CLQ_LIMIT);
        const std::string text = error.what();
        EXPECT_NE(text.find("'heap' has 3000 triangles that lie on one another: more than 512"), std::string::npos)
            << text;
    }
    EXPECT_EQ(model.parts.size(), 1u) << "a refused model stays as it is";
}

TEST(Stacking, OfLayersOfClothIsNotRefused)
{
    EXPECT_EQ(refusal(sheet(20000, 1)), "");
    EXPECT_EQ(refusal(sheet(20000, 0.2)), "") << "a dozen layers";
    EXPECT_EQ(refusal(sheet(500, 0)), "") << "too few to matter";
}

}  // namespace claque
