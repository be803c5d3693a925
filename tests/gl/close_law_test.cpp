// Textures of single individuals show what zones show: with GL_NEAREST and one mip level, within 1 of 255.
#include <cmath>

#include "lib/figures/figure.h"
#include "meshsplit/build.h"
#include "passes/close_distance.h"
#include "tests/gl/support/close.h"
#include "tests/gl/support/split.h"

namespace gltest
{
namespace
{

constexpr gl::Enum lighting = 0x0B50, light0 = 0x4000;

PosedModel citizen_posed()
{
    auto tmpl = std::make_unique<model::Template>(std::pmr::get_default_resource());
    claque::meshsplit::build(claque::figures::citizen(), {}, *tmpl);
    PosedModel posed;
    posed.tmpl = std::move(tmpl);
    skin(*posed.tmpl, model::none, 0, posed.positions, posed.normals);
    measure(posed);
    return posed;
}

class CloseLaw : public GlTest
{
protected:
    void light_up(float strength) const
    {
        const float direction[4] = {0.3f, 0.5f, 0.8f, 0}, colour[4] = {strength, strength * 0.9f, strength * 0.8f, 1};
        host_->MatrixMode(gl::modelview);
        host_->LoadIdentity();
        host_->Lightfv(light0, 0x1203, direction);
        host_->Lightfv(light0, 0x1201, colour);
        host_->Enable(light0);
        host_->Enable(lighting);
    }

    // The largest difference of a channel, in pixels that show the individual.
    int farthest(const PosedModel &posed, const claque::draw::DrawList &list, passes::Strategy strategy,
                 passes::ColourFormat format = passes::ColourFormat::ubyte)
    {
        passes::RendererOptions plain = options_of(strategy), close = nearest_close(strategy);
        plain.colours = close.colours = format;
        const auto without = make_renderer_of(posed, plain), with = make_renderer_of(posed, close);
        const Picture a = draw(*context_, *without, list), b = draw(*context_, *with, list);
        passes::DrawStats stats;
        EXPECT_TRUE(with->draw(list, &stats).ok());
        EXPECT_EQ(stats.close_individuals, list.items.size());
        EXPECT_EQ(stats.draws, list.items.size());
        EXPECT_GT(covered(a), 2000u);
        return largest_difference(a, b);
    }
    int farthest(const PosedModel &posed)
    {
        const std::vector<uint8_t> colours = zone_colours(posed.tmpl->zone_count());
        int most = 0;
        for (const passes::Strategy strategy : all_strategies)
            for (const passes::ColourFormat format : {passes::ColourFormat::ubyte, passes::ColourFormat::real})
                most = std::max(most,
                                farthest(posed, list_of(posed, whole_view(posed), colours.data()), strategy, format));
        return most;
    }
};

TEST_F(CloseLaw, HoldsWithoutLight)
{
    const PosedModel posed = small_posed();
    paint(*posed.tmpl);
    EXPECT_LE(farthest(posed), 1);
}

TEST_F(CloseLaw, HoldsUnderLightOfAtMostOne)
{
    const PosedModel posed = small_posed();
    paint(*posed.tmpl);
    light_up(0.8f);
    EXPECT_LE(farthest(posed), 1);
}

// Fused limits light times colour, and a texture of its own light alone.
TEST_F(CloseLaw, ShowsLessThanFusedWhereLightExceedsOne)
{
    const PosedModel posed = small_posed();
    paint(*posed.tmpl);
    light_up(2.5f);
    EXPECT_GT(farthest(posed), 20);
}

TEST_F(CloseLaw, HoldsForCharacters)
{
    const PosedModel posed = citizen_posed();
    EXPECT_LE(farthest(posed), 1);
}

TEST_F(CloseLaw, HoldsOnHolesAndLeavesThem)
{
    ZoneMap map = torture_map(128, 8, 3);
    for (size_t i = 0; i < map.zones.size(); ++i)
        if (i / 128 % 16 < 5 && i % 16 < 5) map.zones[i] = hole;
    const PosedModel posed = make_posed(sheet(9, 0.2f), map);
    paint(*posed.tmpl);
    EXPECT_LE(farthest(posed), 1);
}

// Vertex colours add one more rounding.
TEST_F(CloseLaw, HoldsWithinTwoUnderVertexColours)
{
    Mesh mesh = sheet(9, 0.2f);
    for (size_t v = 0; v < mesh.positions.size(); ++v)
        mesh.colours.push_back({uint8_t(v * 7), uint8_t(255 - v), uint8_t(90 + v), 255});
    const PosedModel posed = make_posed(mesh, torture_map(128, 8, 3));
    paint(*posed.tmpl);
    EXPECT_LE(farthest(posed), 2);
}

// The library finds where to switch without GL; here is what GL draws.
TEST_F(CloseLaw, TheSwitchIsWhereFilteringChangesTheMeanPixelByTwo)
{
    make_context(256, 512);
    const PosedModel posed = citizen_posed();
    passes::PreparedTemplate prepared(std::pmr::get_default_resource());
    passes::RendererOptions options = close_options();
    options.close_distance_m = 0;
    ASSERT_TRUE(passes::prepare_without_gl(prepared, *posed.tmpl, options, 8).ok());
    ASSERT_GT(prepared.close_distance_m, 0.5f);
    EXPECT_NEAR(passes::close_difference(prepared, 0, prepared.close_distance_m), 2, 0.05);
    const auto without = make_renderer_of(posed), with = make_renderer_of(posed, close_options());
    const float reference_m = posed.radius * 665.1f / (256 / std::tan(0.4f));  // a radius of camera_on()
    double before = 0;
    for (const float radii : {2.7f, 4.0f, 6.0f, 9.0f}) {
        double sum = 0, pixels = 0;
        for (int side = 0; side < 6; ++side) {
            const auto list = list_of(posed, camera_on(posed, radii, 0.5f + float(side), 0, 0.5f));
            const Picture a = draw(*context_, *without, list), b = draw(*context_, *with, list);
            pixels += covered(a);
            for (size_t i = 0; i < a.size(); ++i) sum += std::abs(int(a[i]) - int(b[i]));
        }
        const double mean = sum / (3 * pixels),
                     told = double(passes::close_difference(prepared, 0, radii * reference_m));
        EXPECT_NEAR(told / mean, 1, 0.2) << radii * reference_m << " m: " << mean << ", told " << told;
        EXPECT_GT(mean, before);
        before = mean;
    }
}

}  // namespace
}  // namespace gltest
