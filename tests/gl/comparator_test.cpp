// The comparison behind the law of zones can fail: at one changed bit of one zone's colour, and at one triangle that
// loses one of its zones.
#include "tests/gl/support/fixture.h"

namespace gltest
{
namespace
{

using passes::Strategy;

class Comparator : public GlTest
{
protected:
    Comparison law(const PosedModel &posed, Strategy strategy)
    {
        const auto renderer = make_renderer_of(posed, options_of(strategy));
        const std::vector<uint8_t> colours = zone_colours(posed.tmpl->zone_count());
        const auto list = list_of(posed, whole_view(posed), colours.data());
        return compare(wanted_of(*context_, posed, whole_view(posed)), draw(*context_, *renderer, list));
    }
};

TEST_F(Comparator, SeesOneZoneThatIsOneBitOff)
{
    const PosedModel posed = small_posed();
    const Camera camera = whole_view(posed);
    const auto renderer = make_renderer_of(posed);
    std::vector<uint8_t> colours = zone_colours(8);
    const Wanted wanted = {draw_plain(*context_, posed, camera, colours.data())};
    for (size_t channel = 0; channel < colours.size(); ++channel) {
        colours[channel] ^= 1;
        const Picture coloured = draw(*context_, *renderer, list_of(posed, camera, colours.data()));
        EXPECT_GT(compare(wanted, coloured).wrong, 0u) << "channel " << channel;
        colours[channel] ^= 1;
    }
}

// Removes the last triangle of a range.
void shorten(model::IndexRange &range) { range.count -= 3; }

// Four zones in squares so small that every triangle of the mixed half shows all of them.
PosedModel fine_figure() { return make_posed(sheet(9, 0.2f), torture_map(128, 4, 2)); }

TEST_F(Comparator, SeesATriangleThatLosesAZone)
{
    for (size_t bin = 0; bin < 4; ++bin) {
        PosedModel posed = fine_figure();
        ASSERT_EQ(law(posed, Strategy::binned).wrong, 0u);
        shorten(posed.tmpl->levels[0].surfaces[0].dirty_by_zone[bin].range);
        EXPECT_GT(law(posed, Strategy::binned).wrong, 0u) << "bin " << bin;
    }
    PosedModel posed = fine_figure();
    ASSERT_EQ(law(posed, Strategy::fused).wrong, 0u);
    shorten(posed.tmpl->levels[0].surfaces[0].fused);
    EXPECT_GT(law(posed, Strategy::fused).wrong, 0u);
}

TEST_F(Comparator, SeesAHoleWhereATriangleLosesAllItsZones)
{
    PosedModel posed = fine_figure();
    for (model::Bin &bin : posed.tmpl->levels[0].surfaces[0].dirty_by_zone) shorten(bin.range);
    EXPECT_GT(law(posed, Strategy::binned).holes, 0u);
}

TEST_F(Comparator, SeesTrianglesAtOneDepth)
{
    Mesh mesh = sheet(4, 0.1f);
    const size_t count = mesh.triangles.size();
    for (size_t i = 0; i < count; ++i) mesh.triangles.push_back(mesh.triangles[i]);
    const PosedModel posed = make_posed(mesh, torture_map(64, 4, 3));
    const Comparison c = law(posed, Strategy::fused);
    EXPECT_EQ(c.ties, c.covered);
}

}  // namespace
}  // namespace gltest
