// osgdb_claque (samples/hosts/osg/plugin) as programs of OpenSceneGraph use it: they read files, hang what they get
// below transforms, and know nothing of claque.
#include <set>

#include <osg/Geode>
#include <osg/Sequence>
#include <osg/ShapeDrawable>
#include <osg/Switch>
#include <osgUtil/Statistics>
#include <osgViewer/Renderer>

#include "tests/hosts/osg_plugin_fixture.h"

namespace
{

using namespace osg_plugin_test;

TEST_F(OsgPlugin, ShowsAnIndividualOnEachPathWithColoursOfItsOwn)
{
    const osg::ref_ptr<osg::Node> person = citizen();
    ASSERT_TRUE(person);
    const std::vector<double> places = {-30, 0, 30};
    for (const double x : places) stand(*person, {x, 0, 0});
    const auto picture_at = [&](double x) {
        look_from({x, -4, 0.9}, {x, 0, 0.9});
        return picture(0);
    };
    std::set<std::vector<uint8_t>> looks;
    for (const double x : places) looks.insert(picture_at(x));
    EXPECT_EQ(looks.size(), places.size());
    for (const std::vector<uint8_t> &rgb : looks) EXPECT_GT(people_in(rgb, 0, side_px).size(), 3 * 1500u);
    const std::vector<uint8_t> third = picture_at(places[2]);
    EXPECT_EQ(picture_at(places[2]), third) << "another picture of the same time";

    root_->removeChild(1);
    picture(0);  // the last with that individual
    EXPECT_EQ(people_in(picture_at(places[1]), 0, side_px).size(), 0u) << "its transform is gone";
    EXPECT_EQ(picture_at(places[2]), third);
}

TEST_F(OsgPlugin, StandsPeopleUprightOnZWithTheirFacesTowardsMinusY)
{
    const osg::ref_ptr<osg::Node> person = citizen();
    osg::PositionAttitudeTransform *place = stand(*person, {0, 0, 0});
    const auto rows_of = [](const std::vector<uint8_t> &rgb) {
        std::pair<int, int> rows(side_px, -1);
        for (int y = 0; y < side_px; ++y)
            for (int x = 0; x < side_px; ++x)
                if (!std::equal(rgb.data(), rgb.data() + 3, &rgb[3 * static_cast<size_t>(y * side_px + x)]))
                    rows = {std::min(rows.first, y), std::max(rows.second, y)};
        return rows;
    };
    look_from({0, -4, 0.9}, {0, 0, 0.9});
    const std::vector<uint8_t> front = picture(0);
    // A person of about 1.75 m, at 4 m, in a field of 50 degrees: its feet on z = 0, 0.9 m below the eye.
    const auto [top, bottom] = rows_of(front);
    const double px_per_m = side_px / (2 * 4 * std::tan(25 * 0.017453292519943));
    EXPECT_NEAR(bottom, side_px / 2 + 0.9 * px_per_m, 0.12 * px_per_m);
    EXPECT_NEAR((bottom - top) / px_per_m, 1.75, 0.2);
    // The light is at the eye, and a face is brighter than the hair behind it.
    place->setAttitude(osg::Quat(3.141592653589793, osg::Vec3d(0, 0, 1)));
    const std::vector<uint8_t> back = picture(0);
    const auto head = [&, rows = top](const std::vector<uint8_t> &rgb) {
        size_t sum = 0;
        for (int y = rows + 6; y < rows + 14; ++y)
            for (int x = side_px / 2 - 4; x < side_px / 2 + 4; ++x)
                sum += rgb[3 * static_cast<size_t>(y * side_px + x)];
        return sum / 64;
    };
    EXPECT_GT(head(front), head(back) + 20);
    // A quarter turn to the left: the face is towards +x.
    place->setAttitude(osg::Quat(1.5707963267948966, osg::Vec3d(0, 0, 1)));
    look_from({4, 0, 0.9}, {0, 0, 0.9});
    EXPECT_GT(head(picture(0)), head(back) + 20);
}

// What the guest draws follows from the way: a full cycle of steps farther, the same pose; half of one, another.
TEST_F(OsgPlugin, WalksByTheWayAndStandsWhereOthersWalkOn)
{
    const osg::ref_ptr<osg::Node> person = citizen();
    osg::PositionAttitudeTransform *place = stand(*person, {0, 0, 0});
    osg::ref_ptr<osg::PositionAttitudeTransform> cart = new osg::PositionAttitudeTransform;
    root_->addChild(cart);
    double time_s = 0;
    const auto walk = [&](double metres, double carts_metres) {
        place->setPosition(place->getPosition() + osg::Vec3d(0, -metres, 0));
        cart->setPosition(cart->getPosition() + osg::Vec3d(carts_metres, 0, 0));
        look_from(place->getPosition() + osg::Vec3d(-3, 0, 0.9), place->getPosition() + osg::Vec3d(0, 0, 0.9));
        return picture(time_s += 0.04);
    };
    const std::vector<uint8_t> standing = walk(0, 0);
    for (int i = 0; i < 20; ++i) walk(0.07, 0);
    const std::vector<uint8_t> walking = walk(0.07, 0);
    EXPECT_GT(differing(walking, standing), 400u);
    // The program's clock stands still: so do the legs, in the middle of a step.
    for (int i = 0; i < 10; ++i) EXPECT_LT(differing(walk(0, 0), walking), 30u) << i;
    std::vector<size_t> changes;
    for (int i = 0; i < 40; ++i) changes.push_back(differing(walk(0.05, 0), walking, 40));
    const auto same = std::min_element(changes.begin() + 10, changes.end());
    const double cycle_m = 0.05 * static_cast<double>(same - changes.begin() + 1);
    EXPECT_GT(cycle_m, 1.0);
    EXPECT_LT(cycle_m, 1.8);
    EXPECT_LT(*same * 3, *std::max_element(changes.begin(), changes.end()));
    // Others move and it does not: it stands.
    const std::vector<uint8_t> in_a_step = walk(0, 0);
    std::vector<uint8_t> at_last;
    for (int i = 0; i < 30; ++i) at_last = walk(0, 0.3);
    EXPECT_GT(differing(at_last, in_a_step, 40), 300u);
    EXPECT_LT(differing(at_last, standing, 40), differing(at_last, in_a_step, 40));
}

TEST_F(OsgPlugin, DrawsAllPeopleOfAViewAsOneDrawable)
{
    const osg::ref_ptr<osg::Node> person = citizen();
    const auto drawn = [&] {
        picture(0);
        osgUtil::Statistics statistics;
        auto *renderer = dynamic_cast<osgViewer::Renderer *>(viewer_->getCamera()->getRenderer());
        renderer->getSceneView(0)->getStats(statistics);
        return statistics.numDrawables;
    };
    EXPECT_EQ(drawn(), 0);
    for (int i = 0; i < 30; ++i) stand(*person, {0.5 * (i % 6) - 1.2, 0.5 * (i / 6), 0});
    EXPECT_EQ(drawn(), 1);
}

// Each has a GL context as OSG counts them, and frames of its own.
TEST_F(OsgPlugin, ShowsTheSamePeopleInTwoViewers)
{
    const osg::ref_ptr<osg::Node> person = citizen();
    for (int i = 0; i < 5; ++i) stand(*person, {0.9 * i - 1.8, 0, 0});
    picture(0);
    const std::vector<uint8_t> first = picture(0.02);
    {
        osgViewer::Viewer other;
        other.setThreadingModel(osgViewer::Viewer::SingleThreaded);
        other.setUpViewerAsEmbeddedInWindow(0, 0, side_px, side_px);
        other.setSceneData(root_);
        other.getCamera()->setViewMatrix(viewer_->getCamera()->getViewMatrix());
        other.getCamera()->setProjectionMatrix(viewer_->getCamera()->getProjectionMatrix());
        std::vector<uint8_t> rgb;
        for (int i = 0; i < 3; ++i) {
            other.frame(0.02);
            context_->read_rgb(rgb);
            EXPECT_EQ(rgb, first) << i;
        }
        EXPECT_EQ(picture(0.02), first);
    }
    EXPECT_EQ(picture(0.02), first) << "the other one is closed";
}

// Windows that share textures have one number, and an osg::State each.
TEST_F(OsgPlugin, KeepsTheRenderersOfContextsThatShareTextures)
{
    const osg::ref_ptr<osg::Node> person = citizen();
    stand(*person, {0, 0, 0});
    osgViewer::Viewer other;
    other.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    osg::GraphicsContext &window = *other.setUpViewerAsEmbeddedInWindow(0, 0, side_px, side_px);
    const unsigned shared = viewer_->getCamera()->getGraphicsContext()->getState()->getContextID();
    osg::GraphicsContext::decrementContextIDUsageCount(window.getState()->getContextID());
    osg::GraphicsContext::incrementContextIDUsageCount(shared);
    window.getState()->setContextID(shared);
    other.setSceneData(root_);
    const auto is_texture =
        reinterpret_cast<unsigned char (*)(unsigned)>(context_->get_proc_address()(context_->user(), "glIsTexture"));
    const auto textures = [&] {
        size_t count = 0;
        for (unsigned name = 1; name < 1000; ++name) count += is_texture(name);
        return count;
    };
    const auto draw_both = [&] {
        const std::vector<uint8_t> rgb = picture(0);
        other.frame(0);
        return rgb;
    };
    const std::vector<uint8_t> first = draw_both();
    EXPECT_GT(people_in(first, 0, side_px).size(), 3 * 300u);
    const size_t count = textures();
    EXPECT_GT(count, 1u);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(draw_both(), first) << i;
    EXPECT_EQ(textures(), count);
}

TEST_F(OsgPlugin, LeavesOsgItsState)
{
    osg::ref_ptr<osg::Geode> box = new osg::Geode;
    box->addDrawable(new osg::ShapeDrawable(new osg::Box({-2.5f, 0, 0.5f}, 1)));
    box->getOrCreateStateSet()->setRenderBinDetails(20, "RenderBin");  // after everything else
    root_->addChild(box);
    const std::vector<uint8_t> alone = picture(1);
    const std::vector<uint8_t> box_alone = people_in(alone, 0, side_px / 3);
    ASSERT_GT(box_alone.size(), 3 * 300u);
    stand(*citizen(), {1.5, 0, 0});
    const std::vector<uint8_t> both = picture(1);
    EXPECT_EQ(people_in(both, 0, side_px / 3), box_alone);
    EXPECT_GT(differing(both, alone), 300u);
}

TEST_F(OsgPlugin, HidesTheLightsThatSumoHangsOnPeopleAndNothingElse)
{
    const osg::ref_ptr<osg::Node> person = citizen();
    const auto hang = [&](bool indicators) {
        osg::ref_ptr<osg::PositionAttitudeTransform> place = new osg::PositionAttitudeTransform,
                                                     size = new osg::PositionAttitudeTransform,
                                                     beside = new osg::PositionAttitudeTransform;
        osg::ref_ptr<osg::Switch> lights = new osg::Switch;
        for (int i = 0; i < 2; ++i) lights->addChild(indicators ? new osg::Sequence : new osg::Group);
        lights->addChild(new osg::Geode);
        beside->addChild(new osg::Geode);
        beside->addChild(lights);
        size->addChild(person);
        place->addChild(size);
        place->addChild(beside);
        root_->addChild(place);
        return beside;
    };
    const osg::ref_ptr<osg::Node> lights = hang(true), hat = hang(false);
    picture(0);
    EXPECT_EQ(lights->getNodeMask(), 0u);
    EXPECT_EQ(hat->getNodeMask(), ~0u);
}

}  // namespace
