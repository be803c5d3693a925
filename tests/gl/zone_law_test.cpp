// The law of zones: every pixel shows exactly the zone that its texel names, for every strategy, colour
// format, number of zones, camera and target. The comparison is a plain, unlit picture, drawn in one pass from a
// texture whose RGB is each zone's colour. Templates are made by hand, independently of meshsplit.
#include "tests/gl/support/driver.h"
#include "tests/gl/support/law_fixture.h"

namespace gltest
{
namespace
{

using ZoneLaw = LawTest;

TEST_P(ZoneLaw, HoldsOnSquaresFinerThanTriangles)
{
    const std::vector<uint32_t> all = {1, 2, 8, 10, 16, 48}, few = {2, 48};
    for (const uint32_t zones : on_softpipe() ? few : all) {
        SCOPED_TRACE(testing::Message() << zones << " zones");
        hold(make_posed(sheet(9, 0.2f), torture_map(128, zones, 3)),
             {passes::ColourFormat::ubyte, passes::ColourFormat::real});
    }
}

TEST_P(ZoneLaw, HoldsForThePapersEqualTest)
{
    for (const uint32_t zones : {2u, 8u, 48u}) {
        const PosedModel posed = make_posed(sheet(9, 0.2f), torture_map(128, zones, 3));
        passes::RendererOptions options;
        options.strategy = passes::Strategy::per_zone;
        options.key_test = passes::KeyTest::equal;
        Law(*context_, posed).hold(options, verdict_);
    }
}

// Light that passes every colour unchanged: the zones' colours reach the materials of both faces.
TEST_P(ZoneLaw, HoldsUnderFullAmbientLightOnBothFaces)
{
    constexpr gl::Enum lighting = 0x0B50, light_model_ambient = 0x0B53;
    const float full[4] = {1, 1, 1, 1};
    const HostGl host(*context_);
    const PosedModel posed = make_posed(sheet(9, 0.2f), torture_map(128, 8, 3));
    posed.tmpl->levels[0].surfaces[0].double_sided = true;
    host.LightModelfv(light_model_ambient, full);
    for (const float turn_rad : {0.4f, 2.8f}) {
        const Camera camera = camera_on(posed, 2.6f, turn_rad, 0.4f, 4.0f / 3);
        const Wanted wanted = {draw_plain(*context_, posed, camera, zone_colours(8).data())};
        for (const passes::Strategy strategy :
             {passes::Strategy::fused, passes::Strategy::binned, passes::Strategy::per_zone}) {
            SCOPED_TRACE(testing::Message() << "turned " << turn_rad << ", strategy " << int(strategy));
            passes::RendererOptions options;
            options.strategy = strategy;
            host.Enable(lighting);
            hold(posed, camera, options, wanted);
            host.Disable(lighting);
        }
    }
}

TEST_P(ZoneLaw, HoldsOnMoreVerticesThanShortIndicesReach)
{
    const PosedModel posed = make_posed(sheet(260, 0.2f), torture_map(256, 4, 3));
    ASSERT_GT(posed.tmpl->levels[0].source_count, 65536u);
    const Camera camera = camera_on(posed, 2.6f, 0.4f, 0.4f, 4.0f / 3);
    hold(posed, camera, {}, {draw_plain(*context_, posed, camera, zone_colours(4).data())});
}

INSTANTIATE_TEST_SUITE_P(On, ZoneLaw, testing::ValuesIn(targets()), name_of_target);

}  // namespace
}  // namespace gltest
