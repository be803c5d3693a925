// Triangles that lie on one another are refused before anything takes the square of their number.
#include "lib/lod/surface/stacking.h"

#include <gtest/gtest.h>

#include "lib/base/error.h"

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

}  // namespace

TEST(Stacking, OfTwentyThousandTrianglesIsRefusedWithNumbers)
{
    for (const double step : {0.0, 1e-6}) {
        const std::string text = refusal(sheet(20000, step));
        EXPECT_NE(text.find("'heap' has 20000 triangles"), std::string::npos) << text;
        EXPECT_NE(text.find("512"), std::string::npos) << text;
    }
}

TEST(Stacking, OfLayersOfClothIsNotRefused)
{
    EXPECT_EQ(refusal(sheet(20000, 1)), "");
    EXPECT_EQ(refusal(sheet(20000, 0.2)), "") << "a dozen layers";
    EXPECT_EQ(refusal(sheet(500, 0)), "") << "too few to matter";
}

}  // namespace claque
