// Camera paths: refusals, and a camera that passes the key frames without a jump.
#include <cmath>

#include <gtest/gtest.h>

#include "samples/scenes/camera_path.h"
#include "samples/scenes/check.h"

namespace
{

using scenes::CameraPath;
using scenes::Viewpoint;

const std::string keys =
    "[[keys]]\ntime_s = 0.0\neye = [0.0, 2.0, 10.0]\ntarget = [0.0, 1.0, 0.0]\nfov_deg = 30.0\nnear_m = 0.5\n"
    "[[keys]]\ntime_s = 2.0\neye = [4.0, 3.0, 8.0]\ntarget = [1.0, 1.0, 0.0]\nfov_deg = 50.0\nnear_m = 0.5\n"
    "[[keys]]\ntime_s = 7.0\neye = [9.0, 2.0, 2.0]\ntarget = [0.0, 2.0, 0.0]\nfov_deg = 40.0\nnear_m = 2.0\n";
const std::string whole = "far_m = 900.0\n" + keys + "[[sections]]\nname = \"all\"\nstart_s = 1.0\nend_s = 6.0\n";

std::string with(const std::string &what, const std::string &instead)
{
    std::string text = whole;
    const size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), instead);
}

std::string refusal(const std::string &toml)
{
    try {
        CameraPath(toml, "p.toml");
    } catch (const scenes::Failure &failure) {
        return failure.what();
    }
    return "";
}

double distance(const std::array<double, 3> &a, const std::array<double, 3> &b)
{
    return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

TEST(CameraPath, GoesThroughItsKeyFrames)
{
    const CameraPath path(whole, "p.toml");
    ASSERT_EQ(path.keys().size(), 3u);
    for (const scenes::KeyFrame &key : path.keys()) {
        const Viewpoint at = path.at(key.time_s);
        EXPECT_LT(distance(at.eye, key.view.eye), 1e-9) << key.time_s;
        EXPECT_LT(distance(at.target, key.view.target), 1e-9) << key.time_s;
        EXPECT_NEAR(at.fov_deg, key.view.fov_deg, 1e-9) << key.time_s;
        EXPECT_NEAR(at.near_m, key.view.near_m, 1e-9) << key.time_s;
    }
}

TEST(CameraPath, IsHeldBeforeItsFirstKeyFrameAndAfterItsLast)
{
    const CameraPath path(whole, "p.toml");
    EXPECT_EQ(path.at(-5).eye, path.keys().front().view.eye);
    EXPECT_EQ(path.at(1e9).eye, path.keys().back().view.eye);
}

TEST(CameraPath, HasNoJumpInPositionOrSpeed)
{
    for (const std::string &toml : {whole, *scenes::recorded_path("odeon")}) {
        const CameraPath path(toml, "p.toml");
        const double step = 1e-3;
        double speed_before = 0;
        for (double t = path.start_s() - 0.1; t < path.end_s() + 0.1; t += step) {
            const Viewpoint a = path.at(t), b = path.at(t + step);
            const double speed = distance(a.eye, b.eye) / step;
            ASSERT_LT(speed, 10) << "metres a second at " << t;
            ASSERT_NEAR(speed, speed_before, 0.05) << t;
            ASSERT_LT(distance(a.target, b.target) / step, 10) << t;
            ASSERT_LT(std::abs(a.fov_deg - b.fov_deg) / step, 30) << t;
            speed_before = speed;
        }
    }
}

TEST(CameraPath, OfTheOdeonHasFourSectionsAndNeverZoomsBeyondItsKeys)
{
    const CameraPath path(*scenes::recorded_path("odeon"), "path.toml");
    EXPECT_EQ(path.sections().size(), 4u);
    EXPECT_EQ(scenes::recorded_path("plaza"), nullptr);
    for (size_t k = 0; k + 1 < path.keys().size(); ++k) {
        const scenes::KeyFrame &a = path.keys()[k], &b = path.keys()[k + 1];
        for (double t = a.time_s; t < b.time_s; t += 0.01) {
            EXPECT_GE(path.at(t).fov_deg, std::min(a.view.fov_deg, b.view.fov_deg) - 1e-9);
            EXPECT_LE(path.at(t).fov_deg, std::max(a.view.fov_deg, b.view.fov_deg) + 1e-9);
        }
    }
}

TEST(CameraPath, WithAnInvalidKeyFrameIsRefusedWithItsNumbers)
{
    ASSERT_EQ(refusal(whole), "");
    const struct {
        std::string toml;
        std::vector<std::string> said;
    } refused[] = {
        {"this is no TOML", {"p.toml", "not TOML"}},
        {"", {"p.toml", "lacks", "far_m"}},
        {"far_m = 900.0\n", {"p.toml", "at least 2 key frames", "0"}},
        {with("time_s = 2.0", "time_s = 8.0"), {"key frame 3", "7 s", "8 s"}},
        {with("time_s = 2.0", "time_s = 0.0"), {"key frame 2", "not after"}},
        {with("time_s = 2.0", "time_s = -1.0"), {"key frame 2", "-1"}},
        {with("time_s = 2.0", "time_s = \"two\""), {"key frame 2", "a string"}},
        {with("time_s = 2.0", "time_s = nan"), {"key frame 2", "not finite"}},
        {with("time_s = 2.0\n", ""), {"key frame 2", "lacks 'time_s'"}},
        {with("eye = [4.0, 3.0, 8.0]", "eye = [4.0, 3.0]"), {"key frame 2", "eye", "2 numbers"}},
        {with("eye = [4.0, 3.0, 8.0]", "eye = [1.0, 1.0, 0.0]"), {"key frame 2", "eye and target", "0 m"}},
        {with("eye = [4.0, 3.0, 8.0]", "eye = [1.0, 30.0, 0.0]"), {"key frame 2", "straight up or down"}},
        {with("eye = [4.0, 3.0, 8.0]", "eye = [4.0, 3.0, inf]"), {"key frame 2", "not finite"}},
        {with("fov_deg = 50.0", "fov_deg = 180.0"), {"key frame 2", "fov_deg", "180", "120"}},
        {with("fov_deg = 50.0", "fov_deg = 0.0"), {"key frame 2", "fov_deg", "0"}},
        {with("near_m = 2.0", "near_m = 20.0"), {"key frame 3", "near_m", "20", "5"}},
        {with("far_m = 900.0", "far_m = 1.0"), {"key frame 3", "near_m = 2", "far_m = 1"}},
        {with("fov_deg = 50.0", "fov_deg = 50.0\nroll_deg = 3.0"), {"key frame 2", "unknown key 'roll_deg'"}},
        {with("far_m", "speed = 2.0\nfar_m"), {"unknown key 'speed'"}},
        {with("start_s = 1.0", "start_s = 6.5"), {"section 1", "'all'", "6.5", "ends before it begins"}},
        {with("end_s = 6.0", "end_s = 60.0"), {"section 1", "60", "0 to 7 s"}},
        {with("name = \"all\"", "name = \"\""), {"section 1", "no name"}},
        {whole + "[[sections]]\nname = \"more\"\nstart_s = 5.0\nend_s = 7.0\n", {"section 2", "'more'", "6 s"}},
        {whole + "[[sections]]\nname = \"all\"\nstart_s = 6.0\nend_s = 7.0\n", {"section 2", "'all'"}},
    };
    for (const auto &r : refused) {
        const std::string sentence = refusal(r.toml);
        EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
        EXPECT_EQ(sentence.substr(0, 6), "p.toml") << sentence;
        for (const std::string &said : r.said) EXPECT_NE(sentence.find(said), std::string::npos) << sentence;
    }
}

TEST(CameraPath, ThatSwingsOverItsTargetBetweenTwoKeyFramesIsRefused)
{
    const std::string sentence = refusal(
        "far_m = 9.0\n"
        "[[keys]]\ntime_s = 0\neye = [-5, 9, 0]\ntarget = [0, 0, 0]\nfov_deg = 40\nnear_m = 1\n"
        "[[keys]]\ntime_s = 4\neye = [5, 9, 0]\ntarget = [0, 0, 0]\nfov_deg = 40\nnear_m = 1\n");
    for (const char *said : {"key frame 1 and 2", "at 1.9", "straight up or down"})
        EXPECT_NE(sentence.find(said), std::string::npos) << sentence;
}

}  // namespace
