// The camera that a person moves, and the path that it leaves.
#include <cmath>

#include "samples/scenes/camera_path.h"
#include "tests/view/staged.h"

namespace
{

using view::FreeCamera;
using view_test::Staged;

TEST(FreeCamera, ShowsWhatTheCameraThatItCameFromShows)
{
    const clq_camera camera = scenes::look({3, 4, 12}, {1, 1.5, -2}, 40, 1.5, 0.1, 500);
    const FreeCamera moved = view::free_camera_from(camera, 15);
    const clq_camera again = moved.camera(1.5);
    for (const view::Point &at : {view::Point{1, 1.5, -2}, view::Point{0, 0, 0}, view::Point{4, 2, -9}}) {
        double x = 0, y = 0, x2 = 0, y2 = 0;
        ASSERT_TRUE(view::project(camera, at, x, y));
        ASSERT_TRUE(view::project(again, at, x2, y2));
        EXPECT_NEAR(x, x2, 1e-4);
        EXPECT_NEAR(y, y2, 1e-4);
    }
}

TEST(FreeCamera, TurnsRoundItsTargetAndKeepsItInTheMiddle)
{
    FreeCamera camera;
    const double before = camera.distance_m;
    camera.orbit(0.3, -0.1);
    double x = 1, y = 1;
    ASSERT_TRUE(view::project(camera.camera(1), camera.target, x, y));
    EXPECT_NEAR(x, 0, 1e-6);
    EXPECT_NEAR(y, 0, 1e-6);
    EXPECT_EQ(camera.distance_m, before);
}

TEST(FreeCamera, PansByWhatIsUnderTheMouse)
{
    FreeCamera camera;
    const view::Point held = camera.target;
    camera.pan(0.2, 0.1);  // of the height: 0.4 and 0.2 of half of it
    double x = 0, y = 0;
    ASSERT_TRUE(view::project(camera.camera(1), held, x, y));
    EXPECT_NEAR(x, 0.4, 1e-6);
    EXPECT_NEAR(y, -0.2, 1e-6);
}

TEST(FreeCamera, NeverStandsOnItsHead)
{
    FreeCamera camera;
    for (int k = 0; k < 100; ++k) camera.orbit(0.1, 0.5);
    EXPECT_NO_THROW(camera.camera(1));
    EXPECT_LT(camera.pitch_rad, 0);
    for (int k = 0; k < 300; ++k) camera.zoom(5);
    EXPECT_NO_THROW(camera.camera(1));
    for (int k = 0; k < 300; ++k) camera.zoom(-5);
    EXPECT_NO_THROW(camera.camera(1));
}

class Cameras : public Staged
{
};

TEST_F(Cameras, ObeyMouseWheelAndKeys)
{
    view::View &view = open({}).model().view;
    play({"click \"pause\""});
    EXPECT_EQ(view.mode, view::CameraMode::scene);
    const FreeCamera before = view.free;
    play({"drag view 0.2 0.2 0.5 0.2"});
    EXPECT_EQ(view.mode, view::CameraMode::free);
    EXPECT_NE(view.free.yaw_rad, before.yaw_rad);
    EXPECT_EQ(view.free.target, before.target);
    play({"drag view 0.2 0.2 0.5 0.2 middle"});
    EXPECT_NE(view.free.target, before.target);
    play({"wheel 2"});
    EXPECT_LT(view.free.distance_m, before.distance_m);
    const view::Point stood = view.free.target;
    play({"key W 0.5"});
    EXPECT_NEAR(std::hypot(view.free.target[0] - stood[0], view.free.target[2] - stood[2]), 1.5, 0.13);
    play({"key ctrl+3", "wheel -4", "key 3"});
    EXPECT_EQ(view.free.distance_m, view.kept[2]->distance_m);
    EXPECT_EQ(view.free.target, view.kept[2]->target);
}

TEST_F(Cameras, FollowAPersonThatWalks)
{
    view::Session &s = open({"plaza", 12, 480, 480});
    s.model().picked.actor = s.world().everyone().at(10);
    play({"click \"follow\"", "wait 3"});
    float x = 0, y = 0, radius = 0;
    ASSERT_TRUE(s.world().on_picture(s.model().picked.actor, x, y, radius));
    EXPECT_NEAR(x, static_cast<float>(s.world().width()) / 2, 2);
    EXPECT_NEAR(y, static_cast<float>(s.world().height()) / 2, 2);
}

TEST_F(Cameras, FrameThePickedPerson)
{
    view::Session &s = open({});
    play({"click \"pause\"", "click person 2", "drag view 0.3 0.3 0.5 0.4 middle", "key F", "wait 0.1"});
    view::Box box;
    ASSERT_TRUE(s.world().outline(s.model().picked.actor, box));
    const float width = static_cast<float>(s.world().width()), height = static_cast<float>(s.world().height());
    EXPECT_GT(box.y1 - box.y0, height * 0.6f);
    EXPECT_GT(box.y0, 0);
    EXPECT_LT(box.y1, height);
    EXPECT_NEAR((box.x0 + box.x1) / 2, width / 2, width * 0.1f);
}

TEST_F(Cameras, LeaveAPathThatScenesFollow)
{
    view::Session &s = open({});
    play({"click \"pause\"", "click \"add key\"", "drag view 0.2 0.2 0.3 0.25", "drag \"time\" 0.1 0.3",
          "click \"add key\""});
    ASSERT_EQ(s.model().view.path.size(), 2u);
    const view::View::Key &last = s.model().view.path.back();
    const scenes::CameraPath path(view::path_text(s.model().view), "saved");
    const scenes::Viewpoint there = path.at(last.time_s);
    for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(there.eye[k], last.camera.eye()[k], 1e-3);
}

}  // namespace
