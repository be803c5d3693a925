// The GLUT program of samples/hosts in a window: individuals appear in its picture and change nothing else in it.
#include <cstdlib>
#include <filesystem>
#include <sys/wait.h>

#include <gtest/gtest.h>

#include "tests/cli/picture.h"
#include "tests/hosts/x_server.h"

namespace
{

using cli_test::Picture;

class Glut : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!server_.why_not().empty()) GTEST_SKIP() << server_.why_not();
    }

    // The picture after some frames.
    static Picture run(const std::string &arguments)
    {
        const std::string path =
            testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name() + ".png";
        const int status = std::system((HOST_PROGRAM " --picture " + path + " " + arguments).c_str());
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << arguments;
        Picture picture = cli_test::picture_of(path);
        std::filesystem::remove(path);
        EXPECT_GT(picture.width, 0);
        return picture;
    }

    hosts_test::XServer server_;
};

// Number of differing pixels in a rectangle, top row first.
size_t other_pixels(const Picture &a, const Picture &b, int x0, int y0, int x1, int y1)
{
    size_t other = 0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const size_t at = 3 * static_cast<size_t>(y * a.width + x);
            other += !std::equal(&a.rgb[at], &a.rgb[at] + 3, &b.rgb[at]);
        }
    return other;
}

TEST_F(Glut, HasPeopleInItsPicture)
{
    const Picture with = run("--frames 2"), without = run("--frames 2 --people-until 0");
    ASSERT_EQ(with.rgb.size(), without.rgb.size());
    const size_t other = other_pixels(with, without, 0, 0, with.width, with.height);
    EXPECT_GT(other, with.rgb.size() / 3 / 20);
    EXPECT_LT(other, with.rgb.size() / 3 / 2);
    // What is drawn after them is unchanged: the sky, the nearest lamp and trees, the first line of the panel.
    EXPECT_EQ(other_pixels(with, without, 0, 0, with.width, 28), 0u);
    EXPECT_EQ(other_pixels(with, without, 675, 60, 795, 250), 0u);
}

TEST_F(Glut, FindsItsStateUnchangedAfterClaquesDraw)
{
    const Picture after = run("--frames 4 --people-until 3"), never = run("--frames 4 --people-until 0");
    ASSERT_EQ(after.rgb.size(), never.rgb.size());
    EXPECT_EQ(other_pixels(after, never, 0, 0, after.width, after.height), 0u);
}

// The test above can fail: this host sets its state once and needs it restored.
TEST_F(Glut, FindsItsStateChangedWithoutAGuard)
{
    const Picture after = run("--frames 4 --people-until 3 --guard none"), never = run("--frames 4 --people-until 0");
    ASSERT_EQ(after.rgb.size(), never.rgb.size());
    EXPECT_GT(other_pixels(after, never, 0, 100, after.width, after.height), 1000u);
}

}  // namespace
