// The comparison behind the law of zones is itself shown to fail: at one bit of one zone's colour, and when one
// triangle loses one of its zones.
#include "tests/gl/support/fixture.h"

namespace gltest
{
namespace
{

using passes::Strategy;

class Comparator : public GlTest
{
protected:
    Comparison law(const Figure &figure, Strategy strategy)
    {
        const auto renderer = make_renderer_of(figure, options_of(strategy));
        return zone_law(*context_, *renderer, figure, whole_view(figure));
    }
};

TEST_F(Comparator, SeesOneZoneThatIsOneBitOff)
{
    const Figure figure = small_figure();
    const Camera camera = whole_view(figure);
    const auto renderer = make_renderer_of(figure);
    std::vector<uint8_t> colours = zone_colours(8);
    const Picture plain = draw_plain(*context_, figure, camera, colours.data());
    const Picture ids = draw_ids(*context_, figure, camera, Order::forwards);
    for (size_t channel = 0; channel < colours.size(); ++channel) {
        colours[channel] ^= 1;
        const Picture variety = draw(*context_, *renderer, list_of(figure, camera, colours.data()));
        EXPECT_GT(compare(plain, variety, ids, ids).wrong, 0u) << "channel " << channel;
        colours[channel] ^= 1;
    }
}

// Takes the last triangle out of a range.
void shorten(model::IndexRange &range) { range.count -= 3; }

// Four zones in squares so small that every triangle of the mixed half shows all of them.
Figure fine_figure() { return make_figure(sheet(9, 0.2f), torture_map(128, 4, 2)); }

TEST_F(Comparator, SeesATriangleThatLosesAZone)
{
    for (size_t bin = 0; bin < 4; ++bin) {
        Figure figure = fine_figure();
        ASSERT_EQ(law(figure, Strategy::binned).wrong, 0u);
        shorten(figure.tmpl->levels[0].surfaces[0].dirty_by_zone[bin].range);
        EXPECT_GT(law(figure, Strategy::binned).wrong, 0u) << "bin " << bin;
    }
    Figure figure = fine_figure();
    ASSERT_EQ(law(figure, Strategy::fused).wrong, 0u);
    shorten(figure.tmpl->levels[0].surfaces[0].fused);
    EXPECT_GT(law(figure, Strategy::fused).wrong, 0u);
}

TEST_F(Comparator, SeesAHoleWhereATriangleLosesAllItsZones)
{
    Figure figure = fine_figure();
    for (model::Bin &bin : figure.tmpl->levels[0].surfaces[0].dirty_by_zone) shorten(bin.range);
    EXPECT_GT(law(figure, Strategy::binned).holes, 0u);
}

TEST_F(Comparator, SeesTrianglesAtOneDepth)
{
    Mesh mesh = sheet(4, 0.1f);
    const size_t count = mesh.triangles.size();
    for (size_t i = 0; i < count; ++i) mesh.triangles.push_back(mesh.triangles[i]);
    const Figure figure = make_figure(mesh, torture_map(64, 4, 3));
    const Comparison c = law(figure, Strategy::fused);
    EXPECT_EQ(c.ties, c.covered);
}

}  // namespace
}  // namespace gltest
