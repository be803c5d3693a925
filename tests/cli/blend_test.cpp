// blend: strips of one individual between clips.
#include <fstream>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Blend = Drawing;
using BlendUsage = Command;

std::string strip(std::vector<std::string> more)
{
    more.insert(more.begin(), {"blend", "citizen", "--size", "300x600", "--phases", "3", "--out", "-"});
    const Outcome done = claque(more);
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(done.out.size(), size_t(3) * 300 * 600);
    return done.out;
}

TEST_F(Blend, LeavesAPictureAndSaysWhatEachRowShows)
{
    const Outcome done = claque({"blend", "citizen", "--size", "300x600", "--phases", "3", "--out", path("strip.png")});
    ASSERT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(file_text(path("strip.png")).substr(0, 8), "\x89PNG\r\n\x1a\n");
    size_t at = 0;
    for (const char *row :
         {"row 1: linear", "row 2: smooth", "row 3: inertial", "row 4: masked", "row 5: added", "row 6: in step"}) {
        at = done.out.find(row, at);
        EXPECT_NE(at, std::string::npos) << row << "\n" << done.out;
    }
    EXPECT_NE(done.out.find("stand_wave to sit_cheer"), std::string::npos) << done.out;
    EXPECT_NE(done.out.find("walk 0.00 s x 1.00"), std::string::npos) << done.out;
    EXPECT_EQ(left(), std::vector<std::string>{"strip.png"});
}

TEST_F(Blend, RowsFollowTheClipsThatAreAskedFor)
{
    const std::string one = strip({});
    EXPECT_EQ(strip({}), one) << "the same on every call";
    EXPECT_NE(strip({"--fade", "stand,walk"}), one);
    EXPECT_NE(strip({"--gaits", "jog,walk"}), one);
    EXPECT_NE(strip({"--node", "upper_arm_r"}), one);
    EXPECT_NE(strip({"--length", "2"}), one);
}

TEST_F(BlendUsage, RefusesInOneSentenceWhatIsNotThere)
{
    const auto sentence = [this](std::vector<std::string> more) {
        more.insert(more.begin(), {"blend", "citizen", "--out", path("s.png")});
        const Outcome done = claque(more);
        EXPECT_EQ(done.code, 1) << done.out;
        return done.err;
    };
    const std::string none = sentence({"--over", "swim"});
    EXPECT_NE(none.find("'swim'"), std::string::npos) << none;
    EXPECT_NE(none.find("walk"), std::string::npos) << "says what there is: " << none;
    EXPECT_NE(sentence({"--node", "tail"}).find("tail"), std::string::npos);
    EXPECT_EQ(left(), std::vector<std::string>{});
    EXPECT_EQ(claque({"blend", "citizen"}).code, 2);
    EXPECT_EQ(claque({"blend", "citizen", "--out", path("s.png"), "--phases", "1"}).code, 2);
    EXPECT_EQ(claque({"blend", "citizen", "--out", path("s.png"), "--fade", "walk"}).code, 2);
}

}  // namespace
}  // namespace cli_test
