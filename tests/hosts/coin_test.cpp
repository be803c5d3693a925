// Actors in a Coin scenegraph (samples/hosts/coin): they stand among what Coin draws, and Coin's state stays as it was.
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/nodes/SoTranslation.h>
#include <gtest/gtest.h>

#include "samples/hosts/coin/portico.h"
#include "tests/gl/support/absent.h"

namespace
{

constexpr int width = 400, height = 250;
constexpr int beam_px = 60;  // rows above the people, with the beam that is drawn after them

class Coin : public testing::Test
{
protected:
    void SetUp() override
    {
        std::string why_not;
        context_ =
            contexts::make_offscreen(contexts::Kind::egl, width, height, contexts::PixelFormat::rgba8888, why_not);
        if (!context_) END_WITHOUT_CONTEXT(contexts::Kind::egl, why_not);
        host_ = std::make_unique<coin_host::Portico>(*context_);
    }

    std::vector<uint8_t> picture(double time_s) { return host_->picture(time_s); }
    void hide_people() { host_->people_here().removeAllChildren(); }

    std::unique_ptr<contexts::Offscreen> context_;
    std::unique_ptr<coin_host::Portico> host_;
};

size_t other_pixels(const std::vector<uint8_t> &a, const std::vector<uint8_t> &b, int first_row, int last_row)
{
    size_t other = 0;
    for (size_t i = 3 * size_t(width) * size_t(first_row); i < 3 * size_t(width) * size_t(last_row); i += 3)
        other += !std::equal(&a[i], &a[i] + 3, &b[i]);
    return other;
}

TEST_F(Coin, HasPeopleAmongItsColumns)
{
    const std::vector<uint8_t> with = picture(1), later = picture(1.5);
    EXPECT_GT(host_->people().drawn().individuals, 40u);
    EXPECT_GT(other_pixels(later, with, beam_px, height), 30u) << "no display list keeps them";
    hide_people();
    const std::vector<uint8_t> without = picture(1);
    EXPECT_GT(other_pixels(with, without, beam_px, height), size_t(width * height / 20));
    EXPECT_LT(other_pixels(with, without, beam_px, height), size_t(width * height / 3));
}

TEST_F(Coin, FindsItsStateAsItLeftIt)
{
    const std::vector<uint8_t> with = picture(1);
    EXPECT_EQ(picture(1), with);
    hide_people();
    const std::vector<uint8_t> without = picture(1);
    EXPECT_EQ(other_pixels(with, without, 0, beam_px), 0u) << "what Coin draws after them";
    EXPECT_EQ(picture(1), without);
}

TEST_F(Coin, MovesPeopleByTheTransformsAboveThem)
{
    const std::vector<uint8_t> here = picture(1);
    SoTranslation *away = new SoTranslation;
    host_->people_here().insertChild(away, 0);
    away->translation = SbVec3f(0.5f, 0, 0);
    EXPECT_GT(other_pixels(picture(1), here, beam_px, height), 2000u);
    away->translation = SbVec3f(1000, 0, 0);
    const std::vector<uint8_t> gone = picture(1);
    EXPECT_EQ(host_->people().drawn().individuals, 0u);
    hide_people();
    EXPECT_EQ(picture(1), gone);
}

TEST_F(Coin, KnowsHowMuchRoomTheyTake)
{
    SoGetBoundingBoxAction bounds(SbViewportRegion(width, height));
    bounds.apply(host_->people().node());
    const SbBox3f box = bounds.getBoundingBox();
    EXPECT_EQ(box.getMin()[1], 0);
    EXPECT_EQ(box.getMax()[1], 2);
    EXPECT_GT(box.getMax()[0] - box.getMin()[0], 10);
}

}  // namespace
