// People on targets with several samples a pixel: as the host has it, or as on a target with one.
#include <algorithm>

#include "tests/gl/support/fixture.h"

namespace gltest
{
namespace
{

constexpr int samples = 4;

class Multisample : public GlTest
{
protected:
    void SetUp() override
    {
        std::string why;
        context_ =
            contexts::make_offscreen(contexts::Kind::any, width, height, contexts::PixelFormat::rgba8888, why, samples);
        if (!context_ && why.find("softpipe") != std::string::npos) GTEST_SKIP() << why;
        if (!context_) END_WITHOUT_CONTEXT(contexts::Kind::any, why);
        host_ = std::make_unique<HostGl>(*context_);
    }

    Picture picture(bool multisample)
    {
        passes::RendererOptions options;
        options.multisample = multisample;
        const auto renderer = make_renderer_of(posed_, options);
        const std::vector<uint8_t> colours = zone_colours(posed_.tmpl->zone_count());
        const Picture drawn = draw(*context_, *renderer, list_of(posed_, whole_view(posed_), colours.data()));
        renderer->destroy();
        return drawn;
    }

    // Of a target with one sample a pixel.
    Picture single()
    {
        std::string why;
        auto other = contexts::make_offscreen(contexts::Kind::any, width, height, contexts::PixelFormat::rgba8888, why);
        EXPECT_TRUE(other) << why;
        if (!other) return Picture();
        std::swap(context_, other);
        const Picture drawn = picture(false);
        std::swap(context_, other);
        other.reset();
        context_->make_current();
        return drawn;
    }

    // Pixels that are neither background nor the pure colour of a zone.
    size_t mixed(const Picture &picture) const
    {
        const std::vector<uint8_t> colours = zone_colours(posed_.tmpl->zone_count());
        const auto is = [&](size_t pixel, const uint8_t *rgb) { return std::equal(rgb, rgb + 3, &picture[3 * pixel]); };
        size_t count = 0;
        for (size_t pixel = 0; pixel < picture.size() / 3; ++pixel) {
            bool pure = is(pixel, background);
            for (size_t zone = 0; zone < colours.size(); zone += 3) pure = pure || is(pixel, &colours[zone]);
            count += !pure;
        }
        return count;
    }

    const PosedModel posed_ = small_posed();
};

TEST_F(Multisample, ShowsThePixelsOfATargetWithOneSampleUnlessItIsRequested)
{
    const Picture plain = single();
    EXPECT_EQ(mixed(plain), 0u);
    EXPECT_EQ(picture(false), plain);
}

TEST_F(Multisample, SmoothsEdgesAndLeavesPixelsWithinAsTheyAre)
{
    const Picture plain = single(), smooth = picture(true);
    const size_t edges = mixed(smooth);
    EXPECT_GT(edges, 100u);
    EXPECT_LT(edges, plain.size() / 3 / 4);
    size_t changed = 0;
    for (size_t i = 0; i < plain.size(); i += 3) changed += !std::equal(&plain[i], &plain[i] + 3, &smooth[i]);
    EXPECT_LT(changed, 2 * edges);
}

TEST_F(Multisample, KeepsAHostsSamplesFromReadingOrReplacingTheAlphaOfZoneKeys)
{
    const Picture plain = picture(false), smooth = picture(true);
    for (const gl::Enum what : {gl::sample_alpha_to_coverage, gl::sample_alpha_to_one}) {
        host_->Enable(what);
        EXPECT_EQ(picture(false), plain) << what;
        EXPECT_EQ(picture(true), smooth) << what;
        EXPECT_TRUE(host_->IsEnabled(what)) << what;
        host_->Disable(what);
    }
}

}  // namespace
}  // namespace gltest
