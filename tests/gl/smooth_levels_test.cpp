// Smoothed images of levels: shades within zones are means; zones stay exact to the pixel.
#include "passes/smooth_levels.h"

#include "tests/gl/support/fixture.h"

namespace gltest
{
namespace
{

constexpr uint32_t side = 8;

// A texture of two zones, the left half and the right half, with a light or a dark grey in every other texel.
class SmoothImage : public testing::Test
{
protected:
    SmoothImage() : texture_(std::pmr::get_default_resource())
    {
        texture_.width = texture_.height = side;
        texture_.wrap_s = texture_.wrap_t = model::Wrap::clamp;
        for (uint32_t y = 0; y < side; ++y)
            for (uint32_t x = 0; x < side; ++x) {
                const uint8_t grey = uint8_t((x + y) % 2 ? 200 : 100);
                texture_.rgba.insert(texture_.rgba.end(), {grey, grey, grey, uint8_t(x < side / 2 ? 94 : 255)});
            }
    }
    std::vector<uint8_t> smooth(uint32_t step) const
    {
        std::vector<uint8_t> image(texture_.rgba.begin(), texture_.rgba.end());
        for (uint32_t k = 1; k <= step; ++k) image = passes::smooth_image(texture_, image, side, side, shown_, k);
        return image;
    }
    static size_t at(uint32_t x, uint32_t y) { return 4 * size_t(y * side + x); }

    model::Texture texture_;
    std::vector<uint8_t> shown_ = std::vector<uint8_t>(side * side, 1);
};

TEST_F(SmoothImage, HasTheMeanOfTheTexelsAround)
{
    const std::vector<uint8_t> image = smooth(1);
    EXPECT_EQ(image[at(2, 3)], 150);
    EXPECT_EQ(image[at(6, 4)], 150);
}

TEST_F(SmoothImage, ReachesAboutAsFarAsTexelsFallOnAPixel)
{
    for (uint32_t i = 0; i < side * side; ++i) texture_.rgba[4 * i] = uint8_t(i / side == 3 ? 240 : 0);
    const auto height_of = [&](uint32_t step) {
        const std::vector<uint8_t> image = smooth(step);
        int rows = 0;
        for (uint32_t y = 0; y < side; ++y) rows += image[at(1, y)] > 0;
        return rows;
    };
    EXPECT_EQ(height_of(1), 3);
    EXPECT_EQ(height_of(2), 5);
    EXPECT_EQ(height_of(3), int(side));
}

TEST_F(SmoothImage, KeepsZoneKeys)
{
    for (uint32_t step = 0; step <= passes::max_smooth_step; ++step) {
        const std::vector<uint8_t> image = smooth(step);
        for (size_t i = 3; i < image.size(); i += 4) ASSERT_EQ(image[i], texture_.rgba[i]) << step;
    }
}

TEST_F(SmoothImage, MixesNoZones)
{
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x)
            for (size_t c = 0; c < 3; ++c) texture_.rgba[at(x, y) + c] = uint8_t(x < side / 2 ? 40 : 220);
    for (uint32_t step = 1; step <= passes::max_smooth_step; ++step)
        EXPECT_EQ(smooth(step), std::vector<uint8_t>(texture_.rgba.begin(), texture_.rgba.end())) << step;
}

TEST_F(SmoothImage, LeavesOutTexelsThatNoTriangleShows)
{
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) shown_[at(x, y) / 4] = texture_.rgba[at(x, y)] == 100;
    EXPECT_EQ(smooth(2)[at(2, 2)], 100);
    EXPECT_EQ(smooth(2)[at(2, 3)], 200) << "a texel that is not shown stays";
}

// A second level like the first, at a distance at which many texels fall on a pixel.
class SmoothLevels : public GlTest
{
protected:
    SmoothLevels()
    {
        posed_.tmpl->levels.push_back(posed_.tmpl->levels[0]);
        posed_.tmpl->levels[1].switch_distance_m = 100;
    }
    Picture picture(passes::Strategy strategy, bool smooth, uint32_t level)
    {
        passes::RendererOptions options = options_of(strategy);
        options.smooth_levels = smooth;
        const auto renderer = make_renderer_of(posed_, options);
        claque::draw::DrawList list = list_of(posed_, whole_view(posed_));
        list.items[0].level = level;
        const Picture drawn = draw(*context_, *renderer, list);
        renderer->destroy();
        return drawn;
    }

    PosedModel posed_ = small_posed();
};

TEST_F(SmoothLevels, KeepZonesToThePixelUnderEveryStrategy)
{
    whiten(*posed_.tmpl);
    for (const passes::Strategy strategy : all_strategies)
        EXPECT_EQ(picture(strategy, true, 1), picture(strategy, false, 1)) << int(strategy);
}

TEST_F(SmoothLevels, ShowTheSameUnderEveryStrategyAndNotTheTemplatesTexels)
{
    paint(*posed_.tmpl);
    const Picture first = picture(passes::Strategy::fused, true, 1);
    EXPECT_NE(first, picture(passes::Strategy::fused, false, 1));
    for (const passes::Strategy strategy : all_strategies)
        EXPECT_EQ(picture(strategy, true, 1), first) << int(strategy);
}

TEST_F(SmoothLevels, AreNotTheFinestOne)
{
    paint(*posed_.tmpl);
    EXPECT_EQ(picture(passes::Strategy::fused, true, 0), picture(passes::Strategy::fused, false, 0));
}

TEST_F(SmoothLevels, AreSmoothedByTheTexelsThatFallOnAPixelWhereTheyBegin)
{
    const auto step_at = [&](float distance_m) {
        posed_.tmpl->levels[1].switch_distance_m = distance_m;
        passes::PreparedTemplate prepared(std::pmr::get_default_resource());
        passes::RendererOptions options;
        options.smooth_levels = true;
        EXPECT_TRUE(passes::prepare_without_gl(prepared, *posed_.tmpl, options, 24).ok());
        return int(prepared.levels[1].smooth[0]);
    };
    // 128 texels over two metres; a pixel is 1 / 665 of the distance wide. Slopes and sides show more texels.
    EXPECT_EQ(step_at(1), 0);
    const int at_20 = step_at(20);
    EXPECT_GE(at_20, 1);
    EXPECT_EQ(step_at(40), at_20 + 1);
    EXPECT_EQ(step_at(1e6f), int(passes::max_smooth_step));
}

}  // namespace
}  // namespace gltest
