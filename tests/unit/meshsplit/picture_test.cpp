// The picture of a split: zones in colours of their own, dirty triangles marked (S1 Figs. 4 and 5).
#include "meshsplit/picture.h"

#include <array>
#include <set>

#include <gtest/gtest.h>

#include "models.h"

namespace claque::test
{

namespace
{

constexpr uint32_t scale = 8;

std::array<int, 3> pixel(const std::vector<uint8_t> &picture, uint32_t width, uint32_t x, uint32_t y)
{
    const uint8_t *p = picture.data() + 4 * (size_t(y) * width + x);
    return {p[0], p[1], p[2]};
}

}  // namespace

TEST(Picture, TintsDirtyTrianglesRedAndLeavesCleanOnesInTheirZoneSColour)
{
    // Columns of squares 8 texels wide; the border at 20 lies in the third.
    const auto image = key_image(64, 64, [](uint32_t x, uint32_t) { return uint8_t(x < 20 ? 1 : 2); });
    const auto tmpl = built(keyed_sheet(8, 8, image, {1, 2}));
    const auto picture = meshsplit::split_picture(*tmpl, 0, int(scale));
    const uint32_t width = 64 * scale;
    ASSERT_EQ(picture.size(), 4u * width * width);
    const auto left = pixel(picture, width, 4 * scale, 2 * scale), right = pixel(picture, width, 44 * scale, 2 * scale);
    const auto dirty = pixel(picture, width, 21 * scale, 2 * scale);
    EXPECT_NE(left, right);
    EXPECT_GT(dirty[0] - dirty[1], right[0] - right[1] + 40) << "not redder than the clean ones of its zone";
    std::set<std::array<int, 3>> inside;
    for (uint32_t x = 58 * scale; x < 59 * scale; ++x) inside.insert(pixel(picture, width, x, 62 * scale));
    EXPECT_LE(inside.size(), 2u) << "flat but for an outline";
}

TEST(Picture, IsMadeOfAnyTextureWithTrianglesBeyondItsEdges)
{
    model::Model m = torture(8, 0, 30);
    m.parts[0] = sheet_part(3, 3, {-2.5f, -1}, {40, 3});
    const auto tmpl = built(m);
    EXPECT_EQ(meshsplit::split_picture(*tmpl, 0, 1).size(), 4u * 64 * 64);
    m.materials[0].wrap_s = m.materials[0].wrap_t = model::Wrap::clamp;
    EXPECT_EQ(meshsplit::split_picture(*built(m), 0, 1).size(), 4u * 64 * 64);
}

}  // namespace claque::test
