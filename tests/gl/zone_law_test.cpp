// The law of zones: every pixel of a picture shows exactly the zone that its texel names (SPEC 2), whatever the
// strategy, the colours' format, the number of zones, the camera and the target. Held against a plain, unlit picture
// that is drawn in one go from a texture whose RGB is each zone's colour. Templates are made by hand, apart from
// meshsplit.
#include "tests/gl/support/law_fixture.h"

namespace gltest
{
namespace
{

using ZoneLaw = LawTest;

TEST_P(ZoneLaw, HoldsOnSquaresFinerThanTriangles)
{
    for (const uint32_t zones : {1u, 2u, 8u, 10u, 16u, 48u}) {
        SCOPED_TRACE(testing::Message() << zones << " zones");
        hold(make_figure(sheet(9, 0.2f), torture_map(128, zones, 3)), 0);
    }
}

TEST_P(ZoneLaw, HoldsForThePapersEqualTest)
{
    for (const uint32_t zones : {2u, 8u, 48u}) {
        const Figure figure = make_figure(sheet(9, 0.2f), torture_map(128, zones, 3));
        const Law law(*context_, figure);
        passes::RendererOptions options;
        options.strategy = passes::Strategy::per_zone;
        options.key_test = passes::KeyTest::equal;
        law.hold(options);
    }
}

INSTANTIATE_TEST_SUITE_P(On, ZoneLaw, testing::ValuesIn(all_targets), name_of_target);

}  // namespace
}  // namespace gltest
