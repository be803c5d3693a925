// Three channels with frusta of their own show the same as one wide picture (samples/hosts/multichannel).
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "samples/hosts/multichannel/room.h"
#include "tests/gl/support/absent.h"

namespace
{

using namespace multichannel;

constexpr int width = 256, height = 192, wide = Wall::columns * width;

struct Match {
    size_t other = 0;    // pixels whose bits differ
    size_t strange = 0;  // of them, those that are not even between their neighbours in the other picture
};

// GL rounds the last bit of a vertex differently in a channel and in the wide picture; so an edge may fall on the other
// side of a pixel's centre, which then shows its neighbour. `moved`: pixels by which the first picture is shifted to
// the left.
Match compare(const std::vector<uint8_t> &a, const std::vector<uint8_t> &b, int moved = 0)
{
    Match match;
    for (int y = 1; y + 1 < height; ++y)
        for (int x = 1; x + 1 < wide - moved; ++x) {
            const uint8_t *pixel = &a[3 * static_cast<size_t>(y * wide + x + moved)];
            if (std::equal(pixel, pixel + 3, &b[3 * static_cast<size_t>(y * wide + x)])) continue;
            ++match.other;
            bool between = true;
            for (size_t c = 0; c < 3; ++c) {
                int least = 255, most = 0;
                for (int n = 0; n < 9; ++n) {
                    const int value = b[3 * static_cast<size_t>((y + n / 3 - 1) * wide + x + n % 3 - 1) + c];
                    least = std::min(least, value), most = std::max(most, value);
                }
                between = between && pixel[c] + 1 >= least && pixel[c] <= most + 1;
            }
            match.strange += !between;
        }
    return match;
}

class Multichannel : public testing::Test
{
protected:
    static std::unique_ptr<Room> room;
    static std::string why_not;
    static void SetUpTestSuite()
    {
        if (contexts::make_offscreen(contexts::Kind::any, 8, 8, contexts::PixelFormat::rgba8888, why_not))
            room = std::make_unique<Room>(width, height);
    }
    static void TearDownTestSuite() { room.reset(); }
    void SetUp() override
    {
        if (!room) END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
        room->show(3);
    }
};
std::unique_ptr<Room> Multichannel::room;
std::string Multichannel::why_not;

TEST_F(Multichannel, ShowsWhatOneWidePictureShowsButForRoundedEdges)
{
    constexpr size_t pixels = size_t(wide) * height;
    for (const double time_s : {3.0, 7.7, 11.0}) {
        room->show(time_s);
        const Match match = compare(room->side_by_side(), room->wide());
        EXPECT_LE(match.other, pixels / 1000) << "at " << time_s << " s";
        // Features thinner than a pixel have no similar neighbour.
        EXPECT_LE(match.strange, pixels / 25000) << "at " << time_s << " s";
    }
}

TEST_F(Multichannel, DetectsAChannelThatIsOffByOnePixel)
{
    const Match match = compare(room->side_by_side(), room->wide(), 1);
    EXPECT_GT(match.other, size_t(wide * height) / 10);
}

TEST(MultichannelSpanning, ShowsWhatOneWidePictureShowsToTheBit)
{
    std::string why_not;
    if (!contexts::make_offscreen(contexts::Kind::any, 8, 8, contexts::PixelFormat::rgba8888, why_not))
        END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
    Room spanned(width, height, Surfaces::spanning);
    spanned.show(3);
    EXPECT_TRUE(spanned.side_by_side() == spanned.wide());
}

TEST_F(Multichannel, DrawsActorsAcrossAnEdgeInBothChannels)
{
    uint32_t sum = 0;
    clq_view *views[Wall::columns];
    for (int i = 0; i < Wall::columns; ++i) {
        views[i] = room->channel(i).view();
        sum += room->channel(i).stats().visible;
        EXPECT_GT(room->channel(i).stats().visible, 20u);
    }
    const uint32_t in_wide = room->wide_channel().stats().visible;
    EXPECT_GT(sum, in_wide) << "no actor stands across an edge";

    // The wide picture shows exactly the actors that the channels show.
    const auto visible = [] {
        clq_crowd_stats stats = clq_crowd_stats_init();
        scenes::check(clq_crowd_get_stats(room->people().crowd(), &stats));
        return stats.visible;
    };
    EXPECT_EQ(visible(), in_wide) << "of all four views";
    scenes::check(clq_crowd_update(room->people().crowd(), 3, views, Wall::columns));
    EXPECT_EQ(visible(), in_wide) << "of the three channels alone";
}

TEST_F(Multichannel, PosesEveryActorOnceForAllChannels)
{
    room->show(30);  // far in time: every actor is due
    clq_crowd_stats stats = clq_crowd_stats_init();
    scenes::check(clq_crowd_get_stats(room->people().crowd(), &stats));
    EXPECT_EQ(stats.animated, stats.visible);
    EXPECT_EQ(stats.skinned, stats.visible);
}

}  // namespace
