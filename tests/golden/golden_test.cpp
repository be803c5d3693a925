// Compares the scenes with accepted pictures, pixel for pixel. With softpipe of the Mesa named in mesa.txt no pixel may
// differ: its bits and claque's do not depend on the processor. Another Mesa may round the edges of triangles
// differently, as llvmpipe does, so that a small share of the pixels may differ there.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <sys/wait.h>

#include <gtest/gtest.h>

#include "tests/gl/support/absent.h"
#include "tests/golden/picture.h"

namespace
{

const struct Golden {
    const char *name;
    const char *arguments;
} goldens[] = {
    // People at their finest: how levels are made may change without changing how they are drawn.
    {"plaza", "--scene plaza --lod off --count 400 --size 320x240 --time 1.5"},
    {"plaza-close", "--scene plaza --lod off --count 400 --camera close --size 320x240 --time 1.5"},
    {"odeon", "--scene odeon --lod off --size 320x240 --time 1.5"},
    {"odeon-close", "--scene odeon --lod off --camera close --size 320x240 --time 1.5"},
};

// The name that CTest shows for a case.
void PrintTo(const Golden &golden, std::ostream *out) { *out << golden.name; }

std::string text_of(const std::string &path)
{
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

// The exit status of the command, or 128 and the signal that ended it, as shells say it.
int status_of(const std::string &command)
{
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// Renders and returns the JSON's description of the context.
std::string render(const Golden &golden, const char *driver, const std::string &picture)
{
    const std::string json = std::string(OUTPUT_DIR) + "/" + golden.name + "-" + driver + ".json";
    std::remove(picture.c_str());
    std::remove(json.c_str());
    const int status = status_of(std::string("GALLIUM_DRIVER=") + driver + " " CLAQUE_COMMAND " render " +
                                 golden.arguments + " --out " + picture + " --json " + json);
    EXPECT_EQ(status, 0) << "claque render failed";
    return text_of(json);
}

// With softpipe of the Mesa of mesa.txt no pixel differs. Another rasteriser rounds colours and the edges of triangles
// differently, and changes mipmaps at other places: up to 1.2 % of the pixels of llvmpipe's pictures differ by more
// than 8.
constexpr int steps_of_another_rasteriser = 8;
constexpr double share_of_another_rasteriser = 0.015;

void hold(const Golden &golden, const char *driver)
{
    if (const std::string absent = gltest::absent_gl(contexts::Kind::any); !absent.empty()) GTEST_SKIP() << absent;
    const std::string actual_path = std::string(OUTPUT_DIR) + "/" + golden.name + "-" + driver + "-actual.png";
    const std::string json = render(golden, driver, actual_path);
    std::string mesa = text_of(std::string(GOLDEN_DIR) + "/mesa.txt");
    mesa = mesa.substr(0, mesa.find('\n'));
    ASSERT_FALSE(mesa.empty());
    ASSERT_NE(json.find(driver), std::string::npos) << "drawn by another rasteriser than " << driver << ": " << json;
    const bool same = json.find(mesa) != std::string::npos && driver == std::string("softpipe");
    const Picture expected = read_picture(std::string(GOLDEN_DIR) + "/" + golden.name + ".png");
    const Picture actual = read_picture(actual_path);
    ASSERT_FALSE(expected.rgb.empty()) << golden.name << ".png is missing";
    const Difference difference = compare(expected, actual, same ? 0 : steps_of_another_rasteriser);
    if (difference.pixels)
        write_difference(std::string(OUTPUT_DIR) + "/" + golden.name + "-difference.pgm", expected, actual);
    const double allowed = same ? 0 : share_of_another_rasteriser * double(expected.rgb.size() / 3);
    EXPECT_LE(double(difference.pixels), allowed) << "largest difference " << difference.most << "; see " << actual_path
                                                  << ". If the change is meant: make golden-accept";
    testing::Test::RecordProperty("pixels", std::to_string(difference.pixels));
}

class GoldenPicture : public testing::TestWithParam<Golden>
{
};

}  // namespace

TEST_P(GoldenPicture, IsAsItWasAccepted) { hold(GetParam(), "softpipe"); }

// The picture with the most edges: what is allowed to another Mesa.
TEST(GoldenTolerance, HoldsForAnotherRasteriser) { hold(goldens[0], "llvmpipe"); }

INSTANTIATE_TEST_SUITE_P(scenes, GoldenPicture, testing::ValuesIn(goldens), [](const auto &golden) {
    std::string name = golden.param.name;
    for (char &c : name) c = c == '-' ? '_' : c;
    return name;
});

TEST(Comparator, SeesOnePixelOfOneStep)
{
    Picture a;
    a.width = 4, a.height = 3;
    a.rgb.assign(36, 100);
    Picture b = a;
    EXPECT_EQ(compare(a, b).pixels, 0u);
    b.rgb[17] = 101;
    EXPECT_EQ(compare(a, b).pixels, 1u);
    EXPECT_EQ(compare(a, b).most, 1);
    EXPECT_EQ(compare(a, b, 1).pixels, 0u) << "as much as is allowed";
    b.rgb[17] = 102;
    EXPECT_EQ(compare(a, b, 1).pixels, 1u);
    b.rgb[17] = 101;
    b.width = 3, b.height = 4;
    EXPECT_EQ(compare(a, b).pixels, 12u);
    EXPECT_GT(compare(Picture(), Picture()).pixels, 0u)
        << "two missing pictures are not equal: a missing picture fails";
}
