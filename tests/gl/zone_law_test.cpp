// The law of zones: every pixel of a picture shows exactly the zone that its texel names (SPEC 2), whatever the
// strategy, the colours' format, the number of zones, the camera and the target. Held against a plain, unlit picture
// that is drawn in one go from a texture whose RGB is each zone's colour.
#include "tests/gl/support/pictures.h"

#include <gtest/gtest.h>

namespace gltest
{
namespace
{

using passes::ColourFormat;
using passes::Strategy;

struct Target {
    contexts::Kind kind;
    contexts::PixelFormat format;
    const char *name;
};

constexpr int width = 320, height = 240;

class ZoneLaw : public testing::TestWithParam<Target>
{
protected:
    void SetUp() override
    {
        std::string why;
        context_ = contexts::make_offscreen(GetParam().kind, width, height, GetParam().format, why);
        if (!context_) GTEST_SKIP() << why;
    }

    void hold(const Figure &figure, const passes::RendererOptions &options, double most_ties_share)
    {
        passes::Renderer renderer(std::pmr::get_default_resource(), options);
        const auto opened = renderer.open(context_->get_proc_address(), context_->user());
        ASSERT_TRUE(opened.ok()) << opened.text;
        const auto prepared = renderer.prepare(*figure.tmpl);
        ASSERT_TRUE(prepared.ok()) << prepared.text;
        struct View {
            const char *name;
            float distance_radii, turn_rad, tilt_rad;
        };
        constexpr View views[] = {{"near", 0.9f, 0.3f, 0.2f},
                                  {"whole", 2.6f, -0.5f, 0.4f},
                                  {"far", 30, 0.7f, 0},
                                  {"edge-on", 2.6f, 1.53f, 0}};
        uint64_t covered = 0, ties = 0;
        for (const View &view : views) {
            const Comparison c =
                zone_law(*context_, renderer, figure,
                         camera_on(figure, view.distance_radii, view.turn_rad, view.tilt_rad, float(width) / height));
            covered += c.covered, ties += c.ties;
            EXPECT_EQ(c.wrong, 0u) << view.name << ": of " << c.covered << " pixels";
            EXPECT_EQ(c.holes, 0u) << view.name << ": of " << c.covered << " pixels";
            EXPECT_GT(c.covered, 0u) << view.name;
        }
        EXPECT_LE(double(ties), most_ties_share * double(covered)) << ties << " of " << covered << " pixels tie";
        renderer.destroy();
    }

    std::unique_ptr<contexts::Offscreen> context_;
};

TEST_P(ZoneLaw, HoldsOnATortureSheetForEveryStrategyFormatAndNumberOfZones)
{
    for (const uint32_t zones : {1u, 2u, 8u, 10u, 16u, 48u}) {
        const Figure figure = make_figure(sheet(9, 0.2f), torture_map(128, zones, 3));
        for (const Strategy strategy : {Strategy::fused, Strategy::binned, Strategy::per_zone})
            for (const ColourFormat format : {ColourFormat::ubyte, ColourFormat::real}) {
                SCOPED_TRACE(testing::Message()
                             << zones << " zones, strategy " << int(strategy) << ", format " << int(format));
                passes::RendererOptions options;
                options.strategy = strategy;
                options.colours = format;
                hold(figure, options, 0);
            }
    }
}

constexpr Target targets[] = {
    {contexts::Kind::osmesa, contexts::PixelFormat::rgba8888, "OsmesaRgba8888"},
    {contexts::Kind::osmesa, contexts::PixelFormat::rgb565, "OsmesaRgb565"},
    {contexts::Kind::egl, contexts::PixelFormat::rgba8888, "EglRgba8888"},
    {contexts::Kind::egl, contexts::PixelFormat::rgb565, "EglRgb565"},
};
INSTANTIATE_TEST_SUITE_P(On, ZoneLaw, testing::ValuesIn(targets),
                         [](const auto &target) { return std::string(target.param.name); });

}  // namespace
}  // namespace gltest
