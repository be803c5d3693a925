// Actors inside OpenSceneGraph's cull and draw traversals (samples/hosts/osg): each culls for the other (S0 4.3), and
// osg::State stays consistent with GL.
#include <gtest/gtest.h>

#include "samples/hosts/osg/application.h"
#include "tests/gl/support/absent.h"

namespace
{

using namespace osg_host;

constexpr int picture_width = 320, picture_height = 240;
constexpr uint32_t people = 260;

class Osg : public testing::Test
{
protected:
    void SetUp() override
    {
        std::string why_not;
        context_ = contexts::make_offscreen(contexts::Kind::egl, picture_width, picture_height,
                                            contexts::PixelFormat::rgba8888, why_not);
        if (!context_) END_WITHOUT_CONTEXT(contexts::Kind::egl, why_not);
        host_ = std::make_unique<Application>(*context_, people);
    }

    // The eye at its position on the roofs, rotated about the upright axis.
    Viewpoint turned(double degrees) const
    {
        Viewpoint viewpoint = host_->from_the_roofs();
        viewpoint.at = viewpoint.from +
                       osg::Quat(degrees * 0.017453292519943, osg::Vec3d(0, 1, 0)) * (viewpoint.at - viewpoint.from);
        return viewpoint;
    }

    clq_group_info group(size_t omnibus) const
    {
        clq_group_info info = clq_group_info_init();
        scenes::check(clq_group_get_info(host_->passengers().crowd(), host_->passengers().groups()[omnibus], &info));
        return info;
    }

    std::unique_ptr<contexts::Offscreen> context_;
    std::unique_ptr<Application> host_;
};

size_t other_pixels(const std::vector<uint8_t> &a, const std::vector<uint8_t> &b)
{
    size_t other = 0;
    for (size_t i = 0; i < a.size(); i += 3) other += !std::equal(&a[i], &a[i] + 3, &b[i]);
    return other;
}

TEST_F(Osg, FindsItsStateAsItLeftItAfterPeopleWereDrawn)
{
    const Viewpoint viewpoint = host_->from_the_roofs();
    host_->crowd().setNodeMask(0);
    host_->picture(viewpoint, 2);  // uploads textures
    const std::vector<uint8_t> without = host_->picture(viewpoint, 2);
    host_->crowd().setNodeMask(~0u);
    const std::vector<uint8_t> with = host_->picture(viewpoint, 2);
    EXPECT_GT(host_->crowd().drawn().individuals, 50u);
    EXPECT_EQ(host_->picture(viewpoint, 2), with) << "another picture of the same time";
    host_->crowd().setNodeMask(0);
    EXPECT_EQ(host_->picture(viewpoint, 2), without);
    EXPECT_GT(other_pixels(with, without), without.size() / 3 / 50);
    EXPECT_LT(other_pixels(with, without), without.size() / 3 / 3);
}

TEST_F(Osg, CullsPassengersWithTheirOmnibus)
{
    size_t on = 0, off = 0;
    for (const double degrees : {0.0, 60.0, 120.0, 180.0, 240.0, 300.0}) {
        host_->picture(turned(degrees), 2);
        for (size_t i = 0; i < host_->omnibuses().count(); ++i) {
            EXPECT_EQ(group(i).enabled != 0, host_->omnibuses().is_left(i)) << i << " at " << degrees;
            ++(group(i).enabled ? on : off);
        }
    }
    EXPECT_GT(on, 0u);
    EXPECT_GT(off, on) << "most of a town is not visible";

    // A node that the host hides hides its passengers too.
    host_->picture(host_->from_the_roofs(), 2);
    size_t seen = 0;
    while (!group(seen).visible) ASSERT_LT(++seen, host_->omnibuses().count());
    const uint32_t before = host_->crowd().drawn().individuals;
    host_->street_life().omnibuses()[seen]->setNodeMask(0);
    host_->picture(host_->from_the_roofs(), 2);
    EXPECT_FALSE(group(seen).visible);
    EXPECT_LT(host_->crowd().drawn().individuals, before);
}

TEST_F(Osg, CullsAttachedObjectsWithTheirActors)
{
    size_t shown = 0, hidden = 0;
    for (int degrees = 0; degrees < 360; degrees += 12) {
        host_->picture(turned(degrees), 2);
        for (size_t i = 0; i < StreetLife::parasol_count; ++i) {
            const bool is = host_->crowd().is_held_shown(i);
            EXPECT_EQ(is, host_->crowd().is_shown(host_->street_life().holder(i))) << i << " at " << degrees;
            ++(is ? shown : hidden);
        }
        if (degrees == 48) degrees = 300;  // no individual stands behind the eye
    }
    EXPECT_GT(shown, 0u);
    EXPECT_GT(hidden, 0u);
    // Actors with attached objects have larger spheres.
    clq_actor_info with = clq_actor_info_init(), without = with;
    scenes::check(clq_actor_get_info(host_->passengers().crowd(), host_->street_life().holder(0), &with));
    scenes::check(
        clq_actor_get_info(host_->passengers().crowd(), host_->passengers().cast().actors().back(), &without));
    EXPECT_GT(with.sklsroot_radius, without.sklsroot_radius + 0.8f);
}

// S0 Fig. 10: inside the margin nothing is missing; outside, much of scenery and actors is.
TEST_F(Osg, ShowsAllThatANarrowPyramidMeetsWhereCullingIsForced)
{
    constexpr double share = 0.5;
    const Viewpoint viewpoint = host_->from_the_roofs();
    host_->picture(viewpoint, 2);
    const std::vector<uint8_t> all = host_->picture(viewpoint, 2);
    const size_t pieces = host_->pieces().left_over();
    const uint32_t drawn = host_->crowd().drawn().individuals;
    const std::vector<uint8_t> forced = host_->picture(viewpoint, 2, share);
    EXPECT_LT(host_->pieces().left_over(), pieces);
    EXPECT_LT(host_->crowd().drawn().individuals, drawn);
    size_t inside = 0, outside = 0;
    constexpr int edge_px = 3;  // of the rectangle itself
    for (int y = 0; y < picture_height; ++y)
        for (int x = 0; x < picture_width; ++x) {
            const size_t at = 3 * static_cast<size_t>(y * picture_width + x);
            const bool other = !std::equal(&all[at], &all[at] + 3, &forced[at]);
            const bool within = std::abs(2 * x + 1 - picture_width) < share * picture_width - 2 * edge_px &&
                                std::abs(2 * y + 1 - picture_height) < share * picture_height - 2 * edge_px;
            (within ? inside : outside) += other;
        }
    EXPECT_EQ(inside, 0u);
    EXPECT_GT(outside, size_t(picture_width * picture_height) / 20);
    EXPECT_EQ(host_->picture(viewpoint, 2), all) << "culled as usual again";
}

TEST_F(Osg, ShowsThePyramidFromOutsideAndEverythingAsItWasAfterwards)
{
    const Viewpoint viewpoint = host_->from_the_roofs();
    host_->picture(viewpoint, 2);
    const std::vector<uint8_t> from_outside = host_->picture_of_culling(host_->from_outside(), 2);
    size_t yellow = 0, grey = 0;
    for (size_t i = 0; i < from_outside.size(); i += 3) {
        const int r = from_outside[i], g = from_outside[i + 1], b = from_outside[i + 2];
        yellow += r > 250 && g > 220 && b < 40;
        grey += std::abs(r - g) < 12 && std::abs(g - b) < 16 && r > 60 && r < 200;
    }
    EXPECT_GT(yellow, 200u);
    EXPECT_GT(grey, from_outside.size() / 3 / 10) << "much of the town is culled";
}

}  // namespace
